// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/projection/VolumeProjector.hpp"
#include "geometry/sampleVolume.hpp"

#include <gtest/gtest.h>

namespace tokay::geometry {

TEST(VolumeProjector, points_of_the_volume_are_found) {
    const NurbsVolume volume = sampleVolume();
    const VolumeProjector projector(volume);
    for (const double zeta : {0.0, 0.3, 1.0}) {
        for (const double eta : {0.0, 0.45, 0.9}) {
            for (const double xi : {0.1, 0.62, 1.0}) {
                const Point point = volume.point({xi, eta, zeta});
                const VolumeProjection found = projector.closest(point);
                EXPECT_LT(found.distance, 1e-11); // steps below 1e-12 of the size end the search
                EXPECT_LT((volume.point(found.parameters) - point).norm(), 1e-11);
            }
        }
    }
}

TEST(VolumeProjector, point_outside_gets_the_closest_place_of_the_sides) {
    const NurbsVolume ring = thickened(cylinderPatch({0, 0, 0}, 1.5, 2, 0, 1.5), 1);
    const VolumeProjector projector(ring);
    EXPECT_NEAR(projector.closest({3 * std::cos(0.7), 3 * std::sin(0.7), 1}).distance, 1, 1e-11);
    EXPECT_NEAR(projector.closest({0.5 * std::cos(0.7), 0.5 * std::sin(0.7), 1}).distance, 0.5,
                1e-11);
    EXPECT_NEAR(projector.closest({1.5 * std::cos(0.7), 1.5 * std::sin(0.7), 2.25}).distance, 0.25,
                1e-11);
}

} // namespace tokay::geometry
