// Bullet's soft body: a closed surface of rows x kSectors nodes that keeps its volume, the lowest row fixed.
// No shape of Bullet is a ring, so the tool moves the nodes it meets to its own surface before the step.
#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>
#include <BulletSoftBody/btSoftBodyHelpers.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>

#include <vector>

#include "model.h"

namespace onggi::peers {
namespace {

constexpr double kStepS = 1e-3;
btVector3 at(double x_mm, double y_mm, double z_mm) {
    return {static_cast<btScalar>(x_mm), static_cast<btScalar>(y_mm), static_cast<btScalar>(z_mm)};
}

constexpr double kMassKg = 1.9e-6 * kPi * kWallMm * kWallMm * kHeightMm;

class SoftBody : public Model {
  public:
    explicit SoftBody(int rows)
        : rows_(rows),
          dispatcher_(&configuration_),
          world_(&dispatcher_, &broadphase_, &solver_, &configuration_) {
        world_.setGravity({0, 0, 0});
        world_.getWorldInfo().m_gravity = {0, 0, 0};
        world_.getWorldInfo().air_density = 0;
        // Not by CreateFromTriMesh, which has a table of nodes by nodes.
        std::vector<btVector3> points;
        const auto node = [&](int row, int sector) { return row * kSectors + sector % kSectors; };
        for (int row = 0; row <= rows_; ++row)
            for (int sector = 0; sector < kSectors; ++sector) {
                const double angle = 2.0 * kPi * sector / kSectors;
                points.push_back(
                    at(kWallMm * std::cos(angle), kHeightMm * row / rows_, kWallMm * std::sin(angle)));
            }
        const int bottom = static_cast<int>(points.size());
        points.push_back(at(0.0, 0.0, 0.0));
        points.push_back(at(0.0, kHeightMm, 0.0));
        body_ =
            new btSoftBody(&world_.getWorldInfo(), static_cast<int>(points.size()), points.data(), nullptr);
        for (int sector = 0; sector < kSectors; ++sector) {
            for (int row = 0; row <= rows_; ++row) {
                body_->appendLink(node(row, sector), node(row, sector + 1));
                if (row == rows_) continue;
                body_->appendLink(node(row, sector), node(row + 1, sector));
                body_->appendLink(node(row + 1, sector), node(row, sector + 1));
                body_->appendFace(node(row, sector), node(row + 1, sector), node(row, sector + 1));
                body_->appendFace(node(row, sector + 1), node(row + 1, sector), node(row + 1, sector + 1));
            }
            body_->appendLink(bottom, node(0, sector));
            body_->appendLink(bottom + 1, node(rows_, sector));
            body_->appendFace(bottom, node(0, sector), node(0, sector + 1));
            body_->appendFace(bottom + 1, node(rows_, sector + 1), node(rows_, sector));
        }
        body_->m_materials[0]->m_kLST = 0.9F;
        body_->m_cfg.kVC = 2e-4F;  // the stiffest that its explicit step stands
        body_->m_cfg.kDP = 0.02F;
        body_->m_cfg.piterations = 4;
        body_->m_cfg.collisions = 0;
        body_->setTotalMass(static_cast<btScalar>(kMassKg));
        for (int sector = 0; sector < kSectors; ++sector)
            body_->setMass(node(0, sector), 0);
        body_->setMass(bottom, 0);
        // Of the pose the volume alone (findings/bullet-throws-a-fine-posed-body-on-fixed-nodes-apart.sh).
        body_->setPose(true, false);
        world_.addSoftBody(body_);
    }
    ~SoftBody() override {
        world_.removeSoftBody(body_);
        delete body_;
    }
    double tick(double depth_mm) override {
        double force_mn = 0.0;
        for (int i = 0; i < body_->m_nodes.size(); ++i) {
            btSoftBody::Node& node = body_->m_nodes[i];
            const btScalar radius = std::hypot(node.m_x.x(), node.m_x.z());
            const auto bound =
                static_cast<btScalar>(kWallMm - overlap_mm(static_cast<double>(node.m_x.y()), depth_mm));
            if (radius <= bound || node.m_im == 0 || radius < static_cast<btScalar>(0.5 * kWallMm)) continue;
            const btVector3 outward(node.m_x.x() / radius, 0, node.m_x.z() / radius);
            const btScalar speed = std::max(btScalar(0), node.m_v.dot(outward));
            force_mn +=
                static_cast<double>(((radius - bound) / btScalar(kStepS) + speed) / node.m_im) / kStepS;
            node.m_x -= outward * (radius - bound);
            node.m_v -= outward * speed;
        }
        world_.stepSimulation(btScalar(kStepS), 0, btScalar(kStepS));
        mean_n_ += (force_mn / 1000.0 - mean_n_) / 50.0;
        return mean_n_;
    }
    double wall_mm(double y_mm) override {
        double sum_mm = 0.0;
        const double place = y_mm / kHeightMm * rows_;
        const int below = static_cast<int>(place);
        for (int sector = 0; sector < kSectors; ++sector)
            for (const int row : {below, below + 1}) {
                const btVector3& found = body_->m_nodes[row * kSectors + sector].m_x;
                const double part = row == below ? below + 1.0 - place : place - below;
                sum_mm += part * std::hypot(static_cast<double>(found.x()), static_cast<double>(found.z()));
            }
        return sum_mm / kSectors;
    }

  private:
    int rows_;
    btSoftBodyRigidBodyCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_;
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    btSoftRigidDynamicsWorld world_;
    btSoftBody* body_ = nullptr;
    double mean_n_ = 0.0;  // over the last ticks, because single impulses are rough
};

}  // namespace

std::unique_ptr<Model> bullet_soft_body(int rows) {
    return std::make_unique<SoftBody>(rows);
}

}  // namespace onggi::peers
