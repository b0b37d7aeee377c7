#include "deploy/deploy_options.hpp"
#include "deploy/node_contact.hpp"

#include <gtest/gtest.h>

namespace braidzone {

namespace {

constexpr ContactLaw frictional{
    .offset = 1e-6, .normal_stiffness = 1e5, .tangential_stiffness = 1e4, .friction = 0.2};

/// A node 0.4 um before a wall across x: pressed by 1e5 (1 - 0.4) um = 60 mN.
NodeContact pressed(const ContactLaw& law)
{
    NodeContact contact;
    update(contact, law, {{0.4e-6, Vec3::UnitX()}}, Vec3::Zero());
    return contact;
}

}  // namespace

TEST(NodeContact, PressesWithTheDepthUnderTheOffset)
{
    const NodeContact contact = pressed(frictional);
    EXPECT_TRUE(touches(contact));
    EXPECT_NEAR(contact.normal_force.x(), 0.06, 1e-12);
    EXPECT_NEAR(contact_energy(contact, frictional, Vec3::Zero()), 0.5 * 1e5 * 0.36e-12, 1e-20);
    EXPECT_NEAR(contact_gradient(contact, frictional).x(), 0.06, 1e-12);
    EXPECT_NEAR(contact_hessian(contact, frictional)(0, 0), 1e5, 1e-6);
    EXPECT_EQ(contact_hessian(contact, frictional)(1, 1), 0.0);  // not anchored: it slides freely
}

TEST(NodeContact, IsFreeBeyondTheOffset)
{
    NodeContact contact;
    update(contact, frictional, {{1.5e-6, Vec3::UnitX()}}, Vec3::Zero());
    EXPECT_FALSE(touches(contact));
    EXPECT_EQ(contact_energy(contact, frictional, Vec3::Zero()), 0.0);
    EXPECT_EQ(contact_gradient(contact, frictional), Vec3::Zero());
}

// In a crease of two walls at a right angle both press.
TEST(NodeContact, AddsThePiecesOfACrease)
{
    NodeContact contact;
    update(contact, frictional, {{0.5e-6, Vec3::UnitX()}, {0.8e-6, Vec3::UnitY()}}, Vec3::Zero());
    EXPECT_LT((contact.normal_force - Vec3(0.05, 0.02, 0.0)).norm(), 1e-12);
}

// Coulomb: u_max = 0.2 * 0.06 N / 1e4 N/m = 1.2 um; up to there the spring k_t u, beyond it 12 mN.
TEST(NodeContact, HoldsUpToCoulombsLimitAndSlidesBeyond)
{
    NodeContact contact = pressed(frictional);
    settle(contact, frictional);
    EXPECT_TRUE(contact.anchored);
    for (const auto& [way, expected] : {std::pair{0.7e-6, 0.007}, {1.2e-6, 0.012}, {5e-6, 0.012}}) {
        NodeContact moved = contact;
        update(moved, frictional, {{0.4e-6, Vec3::UnitX()}}, Vec3(0, way, 0));
        EXPECT_NEAR(contact_gradient(moved, frictional).y(), expected, 1e-12) << way;
    }
    update(contact, frictional, {{0.4e-6, Vec3::UnitX()}}, Vec3(0, 5e-6, 0));
    settle(contact, frictional);
    EXPECT_LT((contact.anchor - Vec3(0, 3.8e-6, 0)).norm(), 1e-15);  // 5 um - u_max
    EXPECT_NEAR(contact_gradient(contact, frictional).y(), 0.012, 1e-12);
}

TEST(NodeContact, HoldsForEverAtInfiniteFrictionAndNeverWithout)
{
    ContactLaw law = frictional;
    for (const auto& [friction, expected] : {std::pair{infinite_friction, 1.0}, {0.0, 0.0}}) {
        law.friction = friction;
        NodeContact contact = pressed(law);
        settle(contact, law);
        update(contact, law, {{0.4e-6, Vec3::UnitX()}}, Vec3(0, 1e-4, 0));
        EXPECT_NEAR(contact_gradient(contact, law).y(), expected, 1e-12) << friction;
    }
}

TEST(NodeContact, LosesItsAnchorWithTheWall)
{
    NodeContact contact = pressed(frictional);
    settle(contact, frictional);
    update(contact, frictional, {}, Vec3(-1e-5, 0, 0));
    EXPECT_FALSE(contact.anchored);
    update(contact, frictional, {{0.4e-6, Vec3::UnitX()}}, Vec3(0, 1e-5, 0));
    EXPECT_EQ(contact_gradient(contact, frictional).y(), 0.0);
}

// Central differences; the planes are flat, so that the energy is quadratic by pieces.
TEST(ContactGradient, IsTheDerivativeOfTheEnergy)
{
    NodeContact contact = pressed(frictional);
    settle(contact, frictional);
    for (double way : {0.5e-6, 4e-6}) {
        const Vec3 place(0, way, 0.3e-6);
        update(contact, frictional, {{0.4e-6, Vec3::UnitX()}}, place);
        const Vec3 gradient = contact_gradient(contact, frictional);
        const double step = 1e-11;
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 aside = Vec3::Zero();
            aside[axis] = step;
            const double slope = (contact_energy(contact, frictional, place + aside) -
                                  contact_energy(contact, frictional, place - aside)) /
                                 (2 * step);
            EXPECT_NEAR(gradient[axis], slope, 1e-7) << way << " " << axis;
        }
    }
}

}  // namespace braidzone
