#include "assembly/finish.h"
#include "model/systems.h"
#include "base/bend.h"
#include "forces/bend_force.h"
#include "forces/forces.h"
#include "run/simulation.h"
#include <Eigen/Dense>
#include <QtTest>
#include <iostream>
using namespace ripstop;
namespace {
constexpr double stiffness = 0.2;
constexpr double cell = 0.02;
enum class Mesh { Alternating, OneWay, Equilateral };
System sheet(int columns, int rows, Mesh mesh)
{
    System system = emptySystem(1e-4);
    const double depth = cell * (mesh == Mesh::Equilateral ? std::sqrt(0.75) : 1.0);
    const auto at = [&](int i, int j) { return j * (columns + 1) + i; };
    std::vector<std::array<int,3>> tri;
    std::vector<Vec3> place;
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i)
            place.push_back({(i + (mesh == Mesh::Equilateral && j % 2 ? 0.5 : 0.0)) * cell, 0.0, j * depth});
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const int a = at(i, j), b = at(i + 1, j), c = at(i, j + 1), d = at(i + 1, j + 1);
            const bool rising = mesh == Mesh::Alternating ? (i + j) % 2 == 0 : mesh == Mesh::Equilateral ? j % 2 != 0 : true;
            tri.push_back({a, b, rising ? d : c});
            tri.push_back({rising ? a : b, d, c});
        }
    std::vector<double> mass(place.size(), 0.0);
    for (auto& t : tri) for (int p : t) mass[p] += 0.2 * 0.5 * cell * depth / 3;
    for (size_t p = 0; p < place.size(); ++p) addParticle(system, place[p], mass[p]);
    for (auto& t : tri) addPanel(system, t[0], t[1], t[2], AirLaw::None, 0.0);
    system.bending = {{stiffness, 0.0}};
    finish(system);
    return system;
}
std::vector<Vec3> forcesOf(const System& system, const State& state)
{
    const BendLists& lists = system.of<BendLists>();
    BendScratch bends;
    bends.size(lists);
    ThreadPool alone(1);
    fillBends(system, state, alone, bends);
    std::vector<Vec3> f(state.position.size(), Vec3::Zero());
    for (std::size_t p = 0; p < f.size(); ++p)
        for (int k = lists.at.start[p]; k < lists.at.start[p + 1]; ++k)
            f[p] += Vec3(bends.load[lists.at.items[k]]);
    return f;
}
// largest eigenvalue of M^-1 K over 4 / h^2
double over(const System& system, State state)
{
    const size_t n = state.position.size();
    Eigen::MatrixXd K(3*n,3*n);
    const double e = 1e-7;
    for (size_t p = 0; p < n; ++p) for (int c = 0; c < 3; ++c) {
        const double x0 = state.position[p][c];
        state.position[p][c] = x0 + e; auto f1 = forcesOf(system, state);
        state.position[p][c] = x0 - e; auto f0 = forcesOf(system, state);
        state.position[p][c] = x0;
        for (size_t q = 0; q < n; ++q) for (int d = 0; d < 3; ++d)
            K(3*q+d,3*p+c) = -(f1[q][d]-f0[q][d])/(2*e) / std::sqrt(system.mass[p]*system.mass[q]);
    }
    K = 0.5*(K+K.transpose()).eval();
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> s(K, Eigen::EigenvaluesOnly);
    const double h = stiffStepLimit(system);
    return s.eigenvalues().maxCoeff() * h * h / 4;
}
}
class TestBentCloth : public QObject
{
    Q_OBJECT
private slots:
    void limit()
    {
        for (Mesh mesh : {Mesh::Alternating, Mesh::OneWay, Mesh::Equilateral}) {
            System s = sheet(8, 7, mesh);
            auto affine = [&](const Eigen::Matrix3d& m) { State t = s.start; for (auto& x : t.position) x = Vec3(m * Vec3(x)); return t; };
            std::cout << int(mesh) << " flat " << over(s, s.start);
            for (double a : {0.9, 0.8, 0.7, 0.6}) std::cout << " x" << a << " " << over(s, affine(Vec3(a,1,1).asDiagonal()));
            for (double a : {0.8, 0.7}) std::cout << " z" << a << " " << over(s, affine(Vec3(1,1,a).asDiagonal()));
            for (double a : {0.9, 0.83, 0.8,0.7}) std::cout << " xz" << a << " " << over(s, affine(Vec3(a,1,a).asDiagonal()));
            for (double a : {0.3, 0.6, 1.0}) { Eigen::Matrix3d m = Eigen::Matrix3d::Identity(); m(0,2) = a; std::cout << " shear" << a << " " << over(s, affine(m)); m(0,2)=std::sin(a); m(2,2)=std::cos(a); std::cout << " trellis" << a << " " << over(s, affine(m));}
            for (double a : {0.3, 0.7, 1.0, 1.5}) { State t = s.start; for (auto& x : t.position) { const double r = cell / a; x = Vec3(r*std::sin(x.x()/r), r*(1-std::cos(x.x()/r)), x.z()); } std::cout << " arc" << a << " " << over(s, t); }
            for (double a : {0.1, 0.2, 0.3, 0.5, 1.0}) { double w = 0; for (int seed = 1; seed < 8; ++seed) { Dice dice(seed); State t = s.start; for (auto& x : t.position) x += dice.vector(a*cell); w = std::max(w, over(s, t)); } std::cout << " crumple" << a << " " << w; }
            std::cout << std::endl;
        }
    }
};
QTEST_APPLESS_MAIN(TestBentCloth)
#include "test_bent_cloth.moc"
