#include "app/window/app.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include <SFML/Graphics/Image.hpp>
#include <SFML/Graphics/Texture.hpp>
#include <SFML/Window/Event.hpp>
#include <SFML/Window/Mouse.hpp>

#include "app/window/contender_choice.hpp"
#include "app/window/display.hpp"
#include "app/window/help.hpp"
#include "app/window/panel.hpp"
#include "app/window/plot_export.hpp"
#include "app/window/png_file.hpp"
#include "app/window/scrubber.hpp"
#include "app/window/step_bar.hpp"
#include "app/window/strip.hpp"
#include "app/window/words.hpp"
#include "lab/files/assets.hpp"
#include "lab/files/whole_file.hpp"
#include "world/input_error.hpp"

namespace flipside::app {

namespace {

constexpr double charge_seconds = 2;     ///< to a full launch; the lanes of pinball take 4 % of it, 80 ms
constexpr double most_catch_up = 0.1;    ///< simulated seconds per frame
constexpr double most_stepping = 0.012;  ///< seconds of work per frame
constexpr double between_looks = 1;      ///< seconds, at files

std::optional<Keeper> make_keeper(const PlayOptions& options) {
    const auto file = options.keep ? kept_file() : std::nullopt;
    return file ? std::optional<Keeper>(*file) : std::nullopt;
}

/// Whether the command line says what to show.
bool names_a_show(const PlayOptions& options) {
    return options.scene || options.lesson || options.script || options.dt || !options.engine.empty() ||
           !options.contenders.empty() || !options.settings.empty();
}

/// What was on show last, where that is still good and nothing else is asked for.
Stage first_stage(const PlayOptions& options, const Kept& kept, Notice& notice) {
    const View view = options.view.value_or(kept.view);
    if (!names_a_show(options)) {
        try {
            return {kept.scene, "custom", view, {}, {}, kept.contenders};
        } catch (const InputError& error) {
            notice = "what was on show last is no more: " + std::string(error.what());
        }
    }
    return {options.scene.value_or(Kept{}.scene),
            options.engine.empty() ? "custom" : options.engine,
            view,
            options.settings,
            options.script,
            options.contenders,
            options.dt};
}

}  // namespace

App::App(const PlayOptions& options)
    : keeper_(make_keeper(options)),
      kept_(keeper_ && keeper_->found() ? *keeper_->found() : Kept{}),
      stage_(first_stage(options, kept_, controls_.notice)),
      screenshots_(options.screenshots),
      window_(sf::VideoMode(options.width.value_or(kept_.width), options.height.value_or(kept_.height)),
              "Flipside"),
      scale_(options.scale.value_or(kept_.scale)),
      imgui_(window_, scale_for(window_.getSize(), scale_)),
      accumulator_(stage_.dt(), most_catch_up),
      high_scores_(options.keep ? high_scores_file() : std::nullopt) {
    if (!window_.isOpen()) throw std::runtime_error("cannot open a window: is there a display?");
    controls_.scale = scale_;
    controls_.look = kept_.look;
    controls_.panel_open = kept_.panel_open;
    controls_.plots = kept_.plots;
    controls_.strip = kept_.strip;
    controls_.muted = kept_.muted;
    controls_.has_sound = sound_.has_device();
    if (keeper_ && !keeper_->trouble().empty()) controls_.notice = keeper_->trouble();
    if (options.report) report_.emplace(*options.report);
    if (options.lesson) lessons_.open(*options.lesson, stage_, controls_);
    if (!names_a_show(options)) begin_where_it_ended();
    controls_.lesson_wanted = lessons_.lesson() || controls_.newcomer;
    controls_.table_wanted = !controls_.lesson_wanted;
    window_.setPosition(middle_for(window_.getSize()));
    window_.setFramerateLimit(60);
    window_.setKeyRepeatEnabled(false);
}

/// In a lesson, or at a first start with an offer.
void App::begin_where_it_ended() {
    controls_.newcomer = keeper_ && keeper_->first_start();
    if (kept_.lesson.empty()) return;
    try {
        lessons_.open(lab::lesson_file(kept_.lesson), stage_, controls_);
    } catch (const InputError& error) {
        controls_.notice = "the last lesson is no more: " + std::string(error.what());
    }
}

void App::run() {
    double last = clock_.getElapsedTime().asSeconds();
    while (window_.isOpen()) {
        const double start = clock_.getElapsedTime().asSeconds();
        set_scale();
        for (sf::Event event{}; window_.pollEvent(event);) imgui_.queue(event);
        const double seconds = start - last;
        last = start;
        imgui_.want_keys(controls_.by_keys);
        for (const sf::Event& event : imgui_.begin_frame(seconds)) process(event);
        if (!window_.isOpen()) break;
        read_pad();
        advance(seconds);
        count_up(seconds);
        look_after_game();
        arrange();
        draw();
        if (report_)
            report_->write(stage_, microscope_, lessons_, state_, controls_, layout_, camera_, places_);
        measure(seconds, clock_.getElapsedTime().asSeconds() - start);
        window_.display();
        ++state_.frame;
        look_after_files();
    }
    keep();
}

void App::set_scale() {
    const double wanted = scale_for(window_.getSize(), controls_.scale);
    if (screen_ && wanted == scale_) return;
    if (screen_) imgui_.set_scale(wanted);
    screen_.emplace(wanted);
    scale_ = wanted;
}

void App::change_scale(double by) {
    controls_.scale = std::clamp(scale_ + by, least_scale, largest_scale(state_.width, state_.height));
}

/// Once in a while: the scene is taken anew when its file has changed, and what is kept is written.
void App::look_after_files() {
    const double now = clock_.getElapsedTime().asSeconds();
    if (now < looked_after_ + between_looks) return;
    looked_after_ = now;
    keep();
    if (!scene_file_.changed()) return;
    try {
        stage_.reload();
        controls_.notice.clear();
        look_after_draft();
    } catch (const std::exception& error) {
        controls_.notice = error.what();
    }
}

void App::keep() {
    if (!keeper_) return;
    const Look& look = controls_.look;
    kept_.width = static_cast<unsigned>(std::clamp(state_.width, 200.0, 8192.0));
    kept_.height = static_cast<unsigned>(std::clamp(state_.height, 200.0, 8192.0));
    kept_.scale = controls_.scale;
    kept_.panel_open = controls_.panel_open;
    kept_.strip = controls_.strip;
    kept_.muted = controls_.muted;
    kept_.lesson = lessons_.lesson() ? lessons_.lesson()->name : "";
    // A lesson's own view, overlays and contenders end with it.
    if (stage_.is_from_file()) {
        kept_.scene = kept_name(stage_.scene_name());
        kept_.view = stage_.view();
        kept_.plots = controls_.plots;
        kept_.look = {look.shows, look.random_colours, look.artwork};
        kept_.contenders.clear();
        for (const lab::Contender& contender : stage_.contenders())
            kept_.contenders.push_back(text_of(contender, stage_.scene()));
    }
    const std::string trouble = keeper_->keep(kept_);
    if (!trouble.empty()) controls_.notice = trouble;
}

void App::process(const sf::Event& event) {
    if (take_for_drawing(event)) return;
    switch (event.type) {
        case sf::Event::Closed:
            return close();
        case sf::Event::LostFocus:
            let_keys_go();
            return touch(event);
        case sf::Event::KeyPressed:
            return press(action_of(event.key), event.key.code, true);
        case sf::Event::KeyReleased:
            return press(action_of(event.key.code), event.key.code, false);
        default:
            return touch(event);
    }
}

void App::advance(double seconds) {
    if (editor_.on() || browser_.is_open()) return;
    if (accumulator_.dt() != stage_.dt()) accumulator_ = Accumulator(stage_.dt(), most_catch_up);
    const double simulated = controls_.paused || hand_.slings() ? 0 : seconds * controls_.speed;
    // A launch can be charged while the table stands still: it begins with the next step.
    const double charging = controls_.paused ? seconds : simulated;
    if (held(Action::launch)) state_.charge = std::min(1.0, state_.charge + charging / charge_seconds);
    if (!controls_.paused) controls_.single_steps = 0;
    sound_.begin_frame(stage_, controls_.muted, controls_.speed);
    if (controls_.speed < 1 || controls_.single_steps > 0) helped_game_ = stage_.games();
    const sf::Clock stepping;
    // All engines in step: where one is too slow the table runs slower for all, and the window goes on.
    bool under_way = stage_.under_way();
    const int due = accumulator_.advance(simulated);
    for (int steps = due + controls_.single_steps + (under_way ? 1 : 0); steps > 0; --steps) {
        const double left = most_stepping - stepping.getElapsedTime().asSeconds();
        if (left < 0) break;
        if (controls_.paused && !under_way) --controls_.single_steps;
        under_way = false;
        const double from = stage_.time();
        if (!stage_.step_within(left)) break;
        sound_.step(stage_, from);
        measured_.simulated += stage_.dt();
    }
    sound_.end_frame(stage_, simulated > 0);
    measured_.asked += due * stage_.dt();
    measured_.physics += stepping.getElapsedTime().asSeconds();
}

void App::count_up(double seconds) {
    scores_.resize(stage_.runs().size());
    for (std::size_t i = 0; i < scores_.size(); ++i) {
        const auto score = static_cast<double>(stage_.runs()[i].session().game().score());
        // A tenth of the way at least, so that it arrives.
        const double way = (score - scores_[i]) * std::min(1.0, 8 * seconds * controls_.speed);
        scores_[i] = score < scores_[i] || score - scores_[i] < 1 ? score : scores_[i] + way;
    }
}

void App::arrange() {
    const sf::Vector2u size = window_.getSize();
    state_.width = size.x;
    state_.height = size.y;
    if (editor_.on()) return arrange_edit();
    layout_ = layout_of(stage_, size.x, size.y, scale_, controls_.panel_open ? Column::open : Column::folded,
                        controls_.bar_open, controls_.strip);
    camera_.size = {layout_.panes.front().width, layout_.panes.front().height};
    if (shown_scene_ != stage_.scene_name()) {
        mouse_.fit();
        hand_ = {};
        shown_scene_ = stage_.scene_name();
        scene_file_.watch(stage_.is_from_file() ? lab::scene_file(shown_scene_) : "");
    }
    if (mouse_.fitted()) camera_.fit(view_bounds(stage_.scene()), scale_ * pane_margin);
}

void App::draw() {
    if (editor_.on()) return draw_edit();
    controls_.look.charge = state_.charge;
    controls_.look.picked = hand_.picked();
    controls_.look.sling = hand_.sling(camera_, stage_);
    // The panel may change what is on show, so it comes before the picture of it.
    places_ = draw_panel(layout_.panel, stage_, controls_, lessons_, load_);
    arrange();
    if (!controls_.panel_open) draw_notice_on(layout_.panes.back(), controls_.notice, places_);
    choose_steps_in_headers(screen_->steps(), stage_, places_, controls_.notice);
    drag_strip(layout_, scale_, controls_, places_);
    draw_scrubber(layout_.scrubber, stage_, controls_, places_);
    if (controls_.bar_open) draw_step_bar(layout_.bar, stage_, microscope_, places_);
    const bool inside = controls_.bar_open && microscope_.shows(stage_);
    inspect();
    if (controls_.help_open) draw_help({0, 0, state_.width, state_.height}, key_lines(), places_);
    draw_browser();
    count_up(0);
    state_.slow = slow_in_words();
    Readings readings{{},
                      load_.asked,
                      load_.reached,
                      controls_.paused,
                      controls_.speed,
                      stage_.record_end() - stage_.time(),
                      state_.slow,
                      controls_.plots,
                      {double(sf::Mouse::getPosition(window_).x), double(sf::Mouse::getPosition(window_).y)}};
    for (const double score : scores_) readings.scores.push_back(std::lround(std::floor(score)));
    if (state_.end) readings.end = &*state_.end;
    Look look = controls_.look;
    look.artwork = look.artwork && !controls_.artwork_left_out;
    screen_->draw(window_, stage_, layout_, camera_, look, readings, inside ? &microscope_ : nullptr);
    imgui_.end_frame();
    if (screenshot_wanted_) save_screenshot();
    if (export_wanted_) export_plots();
    if (controls_.save_wanted && !stage_.under_way()) save_game();
    if (std::exchange(controls_.edit_wanted, false)) begin_edit();
    if (std::exchange(controls_.browse_wanted, false)) browse();
}

/// "flipside-1.png", or the next number for which there is none of these files.
std::filesystem::path App::free_name(const std::string& stem,
                                     std::initializer_list<std::string_view> endings) const {
    std::filesystem::path file;
    std::error_code ignored;  // writing says what is wrong with the folder
    const auto taken = [&] {
        return std::ranges::any_of(endings, [&](std::string_view ending) {
            return exists(std::filesystem::path(file).replace_extension(ending), ignored);
        });
    };
    for (int i = 1; file.empty() || taken(); ++i) file = screenshots_ / (stem + std::to_string(i) + ".png");
    create_directories(screenshots_, ignored);
    return file;
}

sf::Image App::picture() const {
    sf::Texture texture;
    texture.create(window_.getSize().x, window_.getSize().y);
    texture.update(window_);
    return texture.copyToImage();
}

/// Where steps take so long that hardly anything moves: whose, and how to go on without it.
std::string App::slow_in_words() const {
    constexpr double hardly = 0.2;
    if (load_.asked == 0 || load_.reached >= hardly * load_.asked) return "";
    const Run& run = stage_.runs()[stage_.slowest()];
    const std::string cost = run.under_way() ? " is still busy with this step"
                                             : " takes " + engineering(run.step_cost(), "s") + " per step";
    return "Slow: " + run.name() + cost + (stage_.runs().size() > 1 ? ".   X takes it away" : "");
}

void App::save_screenshot() {
    screenshot_wanted_ = false;
    const std::filesystem::path file = free_name("flipside-", {".png"});
    try {
        write_png(picture(), file);
        state_.last_screenshot = file.string();
    } catch (const std::runtime_error& error) {
        controls_.notice = error.what();
    }
}

void App::export_plots() {
    export_wanted_ = false;
    const std::filesystem::path file = free_name("flipside-plots-", {".png", ".csv"});
    const sf::Image all = picture();
    const Rect& strip = layout_.strip;
    sf::Image cut;
    cut.create(static_cast<unsigned>(strip.width), static_cast<unsigned>(strip.height));
    cut.copy(all, 0, 0,
             {static_cast<int>(strip.x), static_cast<int>(strip.y), static_cast<int>(strip.width),
              static_cast<int>(strip.height)});
    try {
        write_png(cut, file);
        std::ostringstream csv;
        write_numbers(csv, stage_);
        lab::write_whole_file(std::filesystem::path(file).replace_extension(".csv"), csv.str());
        state_.last_export = std::filesystem::path(file).replace_extension(".csv").string();
        controls_.notice.tell("Saved " + file.filename().string() + " and its numbers as .csv");
    } catch (const std::runtime_error& error) {
        controls_.notice = error.what();
    }
}

/// As a replay, beside the pictures.
void App::save_game() {
    controls_.save_wanted = false;
    const std::filesystem::path file =
        free_name("game-", {lab::replay_ending}).replace_extension(lab::replay_ending);
    try {
        lab::write_whole_file(file, to_json(stage_.game()));
        state_.last_game = std::filesystem::absolute(file).lexically_normal().string();
        controls_.notice.tell("Saved " + state_.last_game);
    } catch (const std::runtime_error& error) {
        controls_.notice = error.what();
    }
}

void App::measure(double frame, double busy) {
    measured_.seconds += frame;
    if (!controls_.paused) measured_.running += frame;
    measured_.busy += busy;
    ++measured_.frames;
    if (measured_.seconds < 1) return;
    load_ = {measured_.frames / measured_.seconds, std::min(1.0, measured_.busy / measured_.seconds),
             measured_.physics / measured_.seconds, measured_.asked / measured_.seconds,
             measured_.simulated / measured_.seconds};
    for (Run& run : stage_.runs()) run.refresh(measured_.running);
    if (controls_.look.artwork) budget_.observe(measured_.seconds, load_.frames_per_second, load_.physics);
    controls_.artwork_left_out = !budget_.affords_artwork();
    measured_ = {};
}

}  // namespace flipside::app
