#include "discrepancy/contact_force.hpp"
#include "support/straight_device.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace braidzone {
namespace {

constexpr double everywhere = std::numeric_limits<double>::infinity();

/// 11 rings of 24 nodes, 1 mm apart from 0 to 10 mm, each node bearing 1 mN.
Deployment loaded()
{
    Deployment deployment = test::straight_device(2e-3, 10e-3, 11);
    deployment.contact_force.assign(deployment.nodes.size(), 1e-3);
    return deployment;
}

}  // namespace

TEST(ContactForce, IsThatOfAllNodes)
{
    EXPECT_NEAR(contact_force(loaded(), -everywhere, everywhere), 11 * 24e-3, 1e-12);
}

// Rings stand for half a millimetre on both sides, the end rings on one side.
TEST(ContactForce, CountsRingsByTheirShareOfTheStretch)
{
    const Deployment device = loaded();
    EXPECT_NEAR(contact_force(device, 2.5e-3, 6.5e-3), 4 * 24e-3, 1e-12);
    EXPECT_NEAR(contact_force(device, 2.75e-3, 6.5e-3), 3.75 * 24e-3, 1e-12);
    EXPECT_NEAR(contact_force(device, -1e-3, 0.25e-3), 0.5 * 24e-3, 1e-12);
    EXPECT_NEAR(contact_force(device, 3e-3, everywhere) + contact_force(device, -everywhere, 3e-3),
                11 * 24e-3, 1e-12);
    EXPECT_EQ(contact_force(device, 11e-3, 12e-3), 0.0);
}

}  // namespace braidzone
