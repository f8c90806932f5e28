// examples/scenes/gas.sh writes the gas of the bench as a scene file.

#include "lab/scenes/elastic_scenes.hpp"

#include <cstdio>
#include <string>

#include <gtest/gtest.h>

#include "places.hpp"
#include "world/scene_file.hpp"

namespace flipside::lab {
namespace {

struct Output {
    std::string text;
    int status = 0;
};

Output output_of_gas_script(const std::string& arguments) {
    const std::string command =
        "'" + flipside::test::source("examples/scenes/gas.sh") + "' " + arguments + " 2>&1";
    FILE* const pipe = popen(command.c_str(), "r");
    Output output;
    for (int c = std::getc(pipe); c != EOF; c = std::getc(pipe)) output.text += static_cast<char>(c);
    output.status = pclose(pipe);
    return output;
}

TEST(ElasticScenes, GasScriptWritesTheGasOfTheBench) {
    for (const int balls : {1, 2, 30}) {
        const Output output = output_of_gas_script(std::to_string(balls));
        ASSERT_EQ(output.status, 0) << output.text;
        const Scene written = parse_scene(output.text, "gas.json"), gas = elastic_gas(balls);
        EXPECT_EQ(written.gravity, gas.gravity);
        EXPECT_EQ(written.rest_speed, gas.rest_speed);
        ASSERT_EQ(written.balls.size(), gas.balls.size());
        for (std::size_t i = 0; i < gas.balls.size(); ++i) {
            const Ball &a = written.balls[i], &b = gas.balls[i];
            EXPECT_LT(length(a.position - b.position), 1e-12) << i;
            EXPECT_LT(length(a.velocity - b.velocity), 1e-12) << i;
            EXPECT_EQ(a.radius, b.radius);
            EXPECT_EQ(written.materials[a.material].restitution, 1);
        }
        EXPECT_EQ(written.materials[written.parts.at(0).material].restitution, 1);
    }
}

TEST(ElasticScenes, GasScriptRefusesWhatIsNoNumberOfBalls) {
    for (const char* wrong : {"", "0", "-3", "1.5", "ten", "'2; echo'", "12345678", "1000001"}) {
        const Output output = output_of_gas_script(wrong);
        EXPECT_NE(output.status, 0) << wrong;
        EXPECT_NE(output.text.find("usage"), std::string::npos) << wrong;
    }
}

}  // namespace
}  // namespace flipside::lab
