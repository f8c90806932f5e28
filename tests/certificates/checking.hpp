#pragma once
/// Makes certificates and has them checked by the program for it.

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "lab/certificates/certificate.hpp"
#include "lab/contenders/engines.hpp"
#include "lab/files/assets.hpp"
#include "places.hpp"
#include "world/scene_file.hpp"
#include "world/script_file.hpp"

namespace flipside {

struct Checked {
    int code;
    std::string says;
};

/// What the checker says of a file with this text.
inline Checked check_certificate(const std::string& json) {
    namespace fs = std::filesystem;
    const fs::path folder = fs::temp_directory_path() / ("flipside-certificate-" + std::to_string(getpid()));
    fs::create_directory(folder);
    const std::string file = (folder / "file").string(), out = (folder / "out").string();
    std::ofstream(file) << json;
    const int status =
        std::system((test::certificate_checker + (" " + file) + " > " + out + " 2>&1").c_str());
    std::ostringstream says;
    says << std::ifstream(out).rdbuf();
    fs::remove_all(folder);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, says.str()};
}

/// A shipped scene, with fewer balls where it can make thousands, and the script beside it.
struct Shipped {
    std::shared_ptr<const Scene> scene;
    Script script;

    explicit Shipped(const std::string& name, int balls = 30) {
        const auto file = lab::scene_file(name);
        scene = std::make_shared<const Scene>(name == "rain" ? load_scene(file, balls) : load_scene(file));
        if (const auto beside = lab::script_beside(file)) script = load_script(*beside, *scene);
    }
    [[nodiscard]] lab::Session session(const char* precision) const {
        const Engine& engine = lab::engine_named("reference");
        const lab::SettingChange change{&engine, "precision", precision};
        return {scene, engine, lab::settings_for(engine, *scene, {&change, 1})};
    }
    [[nodiscard]] lab::Certified certified(lab::Session& session, double seconds) const {
        return lab::certify(session, lab::Timeline(session.world().time(), seconds, lab::default_step),
                            script);
    }
};

}  // namespace flipside
