/// Sound as samples, without a device.

#include "app/sound/mixer.hpp"

#include <gtest/gtest.h>

#include "app/sound/samples.hpp"
#include "lab/process/allocations.hpp"

namespace flipside::app::sound {
namespace {

constexpr Source sources[] = {Source::wall,    Source::post,   Source::bumper, Source::slingshot,
                              Source::flipper, Source::target, Source::ball,   Source::rollover,
                              Source::coil,    Source::launch, Source::drain,  Source::tilt,
                              Source::bonus};
static_assert(std::size(sources) == source_count);

Samples sound_of(const Strike& strike, double seconds = 0.5) {
    Mixer mixer;
    mixer.strike(strike, 0);
    return rendered(mixer, seconds);
}

TEST(Mixer, AHarderHitIsLouderWhateverIsHit) {
    for (const Source source : sources) {
        double before = 0;
        for (const double speed : {0.1, 0.2, 0.5, 1.0, 2.0, 4.0}) {
            const double power = power_of(sound_of({source, speed}));
            EXPECT_GT(power, 1.5 * before) << static_cast<int>(source) << " at " << speed << " m/s";
            before = power;
        }
    }
}

TEST(Mixer, AHarderHitIsBrighter) {
    const auto brightness = [](double speed) {
        const Samples samples = sound_of({Source::wall, speed, 1, 0.4});
        return strength_at(samples, 4080) / strength_at(samples, 620);
    };
    EXPECT_GT(brightness(3), 1.3 * brightness(0.3));
}

TEST(Mixer, FrictionMakesAHitDuller) {
    const auto brightness = [](double friction) {
        const Samples samples = sound_of({Source::wall, 1, 1, friction});
        return strength_at(samples, 2490) / strength_at(samples, 620);
    };
    EXPECT_GT(brightness(0), 3 * brightness(0.4));
}

TEST(Mixer, PitchRaisesEveryMode) {
    const Samples samples = sound_of({Source::bonus, 1, 1.5});
    EXPECT_GT(strength_at(samples, 1.5 * 1046.5), 20 * strength_at(samples, 1046.5));
}

TEST(Mixer, NothingClipsHoweverMuchSoundsAtOnce) {
    Mixer mixer;
    for (std::uint32_t i = 0; i < 500; ++i)
        mixer.strike({sources[i % source_count], 50, 1 + 0.01 * (i % 7), 0, 1, (i % 3) - 1.0},
                     0.001 * (i % 20));
    for (std::size_t pane = 0; pane < Mixer::most_rolling; ++pane) mixer.roll(pane, {30, 0, 1});
    const Samples samples = rendered(mixer, 1);
    EXPECT_LE(peak_of(samples), ceiling);
    EXPECT_GT(peak_of(samples), ceiling / 2);
    // Clipped samples would stand in rows at the ceiling.
    int row = 0, longest = 0;
    for (std::size_t i = 0; i < samples.size(); i += 2) {
        row = std::abs(samples[i]) >= ceiling - 1 ? row + 1 : 0;
        longest = std::max(longest, row);
    }
    EXPECT_LT(longest, 20);
}

/// In step, their amplitudes would add up, and sixteen hits be sixteen times as loud.
TEST(Mixer, HitsAtOnceAddTheirPowersAndAreOneVoice) {
    const auto power = [](int hits, double apart, std::size_t voices) {
        Mixer mixer;
        for (int i = 0; i < hits; ++i) mixer.strike({Source::wall, 0.1}, apart * i);
        EXPECT_EQ(mixer.voices(), voices);
        return power_of(rendered(mixer, 2));
    };
    const double one = power(1, 0, 1);
    EXPECT_NEAR(power(16, 0, 1) / one, 16, 3);  // and a little brighter
    EXPECT_NEAR(power(16, 0.00005, 1) / one, 16, 3);
    EXPECT_NEAR(power(16, 0.06, 16) / one, 16, 1);
}

TEST(Mixer, HitsThatAreOneVoiceComeFromWhereMostOfThemAre) {
    Mixer mixer;
    for (const double pan : {-1.0, 0.8, 1.0, 1.0}) mixer.strike({Source::wall, 0.1, 1, 0, 1, pan}, 0);
    EXPECT_EQ(mixer.voices(), 1U);
    Mixer alone;
    alone.strike({Source::wall, 0.2, 1, 0, 1, 0.45}, 0);
    const Samples samples = rendered(mixer, 0.5), same = rendered(alone, 0.5);
    EXPECT_NEAR(power_of(samples, 0) / power_of(same, 0), 1, 0.02);
    EXPECT_NEAR(power_of(samples, 1) / power_of(same, 1), 1, 0.02);
}

TEST(Mixer, ALoudHitIsHeardAmongManyQuietOnesAndTheLimiterHasNothingToDo) {
    Mixer mixer;
    for (int i = 0; i < 300; ++i) mixer.strike({i % 2 == 0 ? Source::wall : Source::ball, 2}, 0.001 * i);
    mixer.strike({Source::bonus, 3}, 0.15);
    const Samples samples = rendered(mixer, 0.5);
    EXPECT_LT(peak_of(samples), 0.97 * ceiling);
    const auto after = std::span(samples).subspan(2 * 8000);
    EXPECT_GT(strength_at(after, 1046.5), 2 * strength_at(after, 620));
}

TEST(Mixer, PolyphonyIsBoundedAndTheLoudestStay) {
    Mixer mixer;
    mixer.strike({Source::bonus, 3}, 0);
    for (int i = 0; i < 400; ++i) mixer.strike({Source::wall, 0.02 + 0.00002 * i}, 0.002 * i);
    EXPECT_EQ(mixer.voices(), Mixer::most_voices);
    const Samples samples = rendered(mixer, 0.2);
    EXPECT_GT(strength_at(samples, 1046.5), 10 * strength_at(samples, 620));
    static_cast<void>(rendered(mixer, 5));
    EXPECT_EQ(mixer.voices(), 0U);
}

TEST(Mixer, NothingIsAllocatedWhileItPlays) {
    Mixer mixer;
    Samples samples(8192);
    const std::uint64_t before = lab::allocations();
    for (int i = 0; i < 100; ++i) {
        for (std::size_t hit = 0; hit < 100; ++hit) mixer.strike({sources[hit % source_count], 1}, 0.01);
        mixer.roll(0, {1, 0, 1});
        mixer.render(samples);
    }
    EXPECT_EQ(lab::allocations(), before);
}

TEST(Mixer, MutedItIsSilentAndUnmutedItGoesOn) {
    Mixer mixer;
    mixer.strike({Source::bonus, 1}, 0);
    mixer.roll(0, {2, 0, 1});
    EXPECT_GT(peak_of(rendered(mixer, 0.1)), 1000);
    mixer.mute(true);
    static_cast<void>(rendered(mixer, 0.015));  // fades out
    mixer.strike({Source::tilt, 1}, 0);
    EXPECT_EQ(peak_of(rendered(mixer, 1)), 0);
    EXPECT_EQ(mixer.voices(), 0U);
    mixer.roll(0, {});
    static_cast<void>(rendered(mixer, 0.5));
    mixer.mute(false);
    EXPECT_EQ(peak_of(rendered(mixer, 0.5)), 0) << "what rang before rings on";
    mixer.strike({Source::wall, 1}, 0);
    EXPECT_GT(peak_of(rendered(mixer, 0.1)), 500);
}

TEST(Mixer, AStrikeBeginsWhenItIsDueToTheSample) {
    Mixer mixer;
    mixer.strike({Source::bonus, 1}, 0.25);
    const Samples samples = rendered(mixer, 0.5);
    const auto first = std::ranges::find_if(samples, [](std::int16_t sample) { return sample != 0; });
    EXPECT_NEAR(static_cast<double>(first - samples.begin()) / 2, sample_rate / 4 + Mixer::latency, 3);
}

TEST(Mixer, ThePortionsInWhichItIsAskedForChangeNoSample) {
    const auto in_portions = [](std::size_t frames) {
        Mixer mixer;
        Samples all;
        for (std::size_t i = 0; i < 8 * 735 / frames; ++i) {
            if (i * frames % 735 == 0) mixer.strike({Source::bumper, 2.0 + double(i * frames)}, 0.02);
            Samples part(2 * frames);
            mixer.render(part);
            all.insert(all.end(), part.begin(), part.end());
        }
        return all;
    };
    const Samples whole = in_portions(735);
    EXPECT_GT(peak_of(whole), 1000);
    EXPECT_EQ(whole, in_portions(105));
    EXPECT_EQ(whole, in_portions(1));
}

TEST(Mixer, ItComesFromWhereItIs) {
    EXPECT_EQ(power_of(sound_of({Source::wall, 1, 1, 0, 1, -1}), 1), 0);
    const Samples right = sound_of({Source::wall, 1, 1, 0, 1, 0.5});
    EXPECT_GT(power_of(right, 1), 3 * power_of(right, 0));
    // As loud wherever it is.
    const double middle = power_of(sound_of({Source::wall, 1}));
    EXPECT_NEAR(power_of(right) / middle, 1, 0.02);
}

TEST(Mixer, RollingIsLouderTheFasterAndEndsWithTheMotion) {
    double before = 0;
    for (const double speed : {0.1, 0.5, 2.0}) {
        Mixer mixer;
        mixer.roll(0, {speed, 0, 1});
        static_cast<void>(rendered(mixer, 0.2));
        const double power = power_of(rendered(mixer, 1));
        EXPECT_GT(power, 3 * before);
        before = power;
        mixer.roll(0, {});
        static_cast<void>(rendered(mixer, 0.5));
        EXPECT_EQ(peak_of(rendered(mixer, 0.5)), 0);
    }
}

}  // namespace
}  // namespace flipside::app::sound
