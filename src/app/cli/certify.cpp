#include "app/cli/commands.hpp"
#include "app/cli/output.hpp"
#include "app/cli/run_options.hpp"
#include "lab/certificates/certificate.hpp"
#include "lab/files/whole_file.hpp"
#include "world/trace.hpp"

namespace flipside::app {

namespace {

struct CertifyOptions : RunOptions {
    std::string from, out;  ///< files; from: "" where not asked for
};

int write_certificate(const CertifyOptions& options) {
    FilesOfCommand files{options.inputs(), {{"--out", options.out}}};
    files.inputs.push_back({"--from", options.from});
    require_distinct(files);
    const auto scene = options.load();
    const Engine& engine = lab::engine_named("reference");
    const Engine* const used[] = {&engine};
    std::vector<lab::SettingChange> changes = {{&engine, "precision", "113"}};
    for (auto& change : lab::parse_changes(options.settings, used)) changes.push_back(std::move(change));
    lab::Session session(scene, engine, lab::settings_for(engine, *scene, changes));
    restore_from(options.from, session);
    const lab::Timeline timeline(session.world().time(), options.seconds, options.step(*scene));
    const Script script = options.load_script(*scene);
    lab::WholeFile file(options.out);
    const lab::Certified certified = lab::certify(session, timeline, script);
    file.out() << certified.json;
    file.finish();
    if (!certified.ends.empty())
        say("the certificate ends after " + brief(certified.seconds) + " s: " + certified.ends);
    return 0;
}

}  // namespace

void add_certify(CLI::App& program, Action& chosen) {
    auto options = std::make_shared<CertifyOptions>();
    CLI::App& command = *program.add_subcommand(
        "certify",
        "Run a scene on the reference and write a certificate of it, for flipside_check_certificate");
    options->add_to(command, "K=V");
    options->add_seconds(command);
    command
        .add_option("--from", options->from,
                    "Start from a state of the same table that `run --save` wrote, on any engine")
        ->type_name("STATE");
    command.add_option("--out", options->out, "The certificate (see assets/certificate.schema.json)")
        ->required()
        ->type_name("FILE");
    command.callback([options, &chosen] { chosen = [options] { return write_certificate(*options); }; });
}

}  // namespace flipside::app
