// A molecule that gives way to the hand: felt, drawn, recorded, played back. Oracle: the network's compliance times the
// force.
#include "app/ui/extensions/elastic_molecule.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "app/ui/extensions/extensions.h"
#include "engine/haptics/field/pair_model.h"
#include "tests/app/small_window.h"
#include "tests/dynamics/networks.h"
#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

std::string lessonWith(const std::string& keys) {
  return "---\ntitle: T\nminutes: 1\ngoals: G\nmolecules: 1ubq, 4ake, 1ake\nauthor: A\nlicence: L\n---\n## One\n"
         "```scene\n" +
         keys + "```\n```touch\nreach: residue 4\nsay: Touch it.\n```\n\n> [!TIP]\n> Look.\n";
}

TEST_CASE(
    "a pushed elastic molecule comes to rest where compliance times force says, within 5 %; released, every atom "
    "returns "
    "within 0.01 A; a playback puts the atoms where they were within 0.02 A") {
  const ScratchFolder scratch;
  writeFile(scratch.path / "mine.md", lessonWith("molecule: 1ubq\nelastic: on\nstiffness: 1 N/mm\n"));
  fs::path file;
  {
    const auto user = startWith((scratch.path / "mine.md").string(), smallWindow(scratch.path));
    Application& app = user->app();
    const ElasticMolecule& elastic = app.extensions().movers.get<ElasticMolecule>();
    REQUIRE(elastic.on());
    REQUIRE(elastic.model());
    const SharedArray<Sphere> rest = app.scene.atoms().seen()->spheres;
    pressDeep(*user);
    user->frames(1200);
    const ServoSample& now = app.scene.log().latest();
    REQUIRE(now.contact.touching());
    // The displacements of all nodes under the reactions of this tick, by the dense pseudo-inverse.
    const ElasticModel& model = *elastic.model();
    app.scene.servo().loop().wantReactions(true);
    user->frames(2);
    Eigen::VectorXd f = Eigen::VectorXd::Zero(Eigen::Index(3 * model.network->nodes().size()));
    double sum_N = 0.0;
    for (const AtomForce& r : app.scene.servo().loop().reactions().forces()) {
      for (int c = 0; c < 3; ++c)
        f[Eigen::Index(3 * model.network->nodeOf(std::size_t(r.atom))) + c] +=
            r.force_N[c] * ElasticMolecule::kScale_pN_per_N / kForceUnit_pN / model.spring_kcal_mol_A2;
      sum_N += glm::length(r.force_N);
    }
    CHECK(sum_N > 0.3);
    const Eigen::VectorXd expected = test::pseudoInverse(test::denseHessian(*model.network)) * f;
    double greatest = 0.0, off = 0.0;
    for (std::size_t n = 0; n < model.network->nodes().size(); ++n) {
      const Eigen::Index at = Eigen::Index(3 * n);
      const Vec3 e(expected[at], expected[at + 1], expected[at + 2]);
      const std::uint32_t atom = model.network->nodes()[n];
      const Vec3 moved = app.scene.atoms().seen()->spheres[atom].centre_A - rest[atom].centre_A;
      greatest = std::max(greatest, glm::length(e));
      off = std::max(off, glm::distance(moved, e));
    }
    CHECK(greatest > 0.3);
    CHECK(off < 0.05 * greatest);
    user->release();
    user->frames(1200);
    CHECK(farthestFrom_A(*user, rest) < 0.01);
    REQUIRE(app.extensions().recorder.flush());
    file = app.extensions().recorder.file();
  }
  const Expected<Attempt> attempt = readAttempt(file);
  REQUIRE(bool(attempt));
  CHECK(attempt->problems.empty());
  double greatest = 0.0, at_s = 0.0;
  for (const AttemptEvent& e : attempt->events)
    if (const auto* moved = std::get_if<AtomsMoved>(&e.what)) {
      CHECK(moved->by == "elastic");
      if (moved->position > greatest) greatest = moved->position, at_s = e.t_s;
    }
  REQUIRE(greatest > 0.1);
  const auto user = startWith("1ubq", smallWindow({}));
  user->app().open(file);
  user->app().finishLoading();
  Playback& playback = user->app().extensions().playback;
  playback.setRunning(false);
  playback.seek(at_s + 1e-3);
  user->app().finishLoading();
  user->frames(5);
  CHECK(farthestFrom_A(*user, user->app().scene.atoms().resting().spheres->spheres()) ==
        doctest::Approx(greatest).epsilon(0.02));
}

TEST_CASE("switched on for any molecule, shown in a mode, and switched off: the atoms are back at once") {
  const auto user = startWith("4ake", smallWindow({}));
  Application& app = user->app();
  ElasticMolecule& elastic = app.extensions().movers.get<ElasticMolecule>();
  const SharedArray<Sphere> rest = app.scene.atoms().seen()->spheres;
  elastic.start();
  user->frames(5);
  CHECK(farthestFrom_A(*user, rest) == 0.0);
  elastic.showMode(true);
  user->frames(65);  // a quarter of its period
  CHECK(farthestFrom_A(*user, rest) == doctest::Approx(ElasticMolecule::kShown_A).epsilon(0.05));
  CHECK(elastic.energy_kcal_mol() < 0.1);  // it is shown without stretching a spring
  elastic.end();
  user->frames(5);
  CHECK(farthestFrom_A(*user, rest) == 0.0);
  CHECK_FALSE(elastic.live());
  // Forces between atoms need a molecule at rest: they switch it off, with a message, and it stays off.
  elastic.start();
  elastic.showMode(true);
  user->frames(30);
  TouchSetup touch = app.scene.touch();
  touch.forces = "van-der-waals";
  app.scene.setTouch(touch);
  user->frames(5);
  CHECK_FALSE(elastic.on());
  CHECK(farthestFrom_A(*user, rest) == 0.0);
  CHECK(contains(app.messages.all().back().text, "Forces between atoms act in a molecule at rest."));
  elastic.start();
  CHECK_FALSE(elastic.on());
}

TEST_CASE(
    "a molecule that yields in modes 1 and 3 only is displaced along these within 1e-9 of its displacement, and with "
    "mode 3 switched off along mode 1 alone") {
  const ScratchFolder scratch;
  writeFile(scratch.path / "mine.md", lessonWith("molecule: 1ubq\nelastic: on\nmodes: 3, 1\nstiffness: 1 N/mm\n"
                                                 "panels: motion\n"));
  const auto user = startWith((scratch.path / "mine.md").string(), smallWindow(scratch.path));
  Application& app = user->app();
  ElasticMolecule& elastic = app.extensions().movers.get<ElasticMolecule>();
  REQUIRE(elastic.model());
  CHECK(elastic.feltModes() == std::vector<std::size_t>{0, 2});
  const SharedArray<Sphere> rest = app.scene.atoms().seen()->spheres;
  pressDeep(*user);
  user->frames(600);
  // The length of the displacement, its amplitude along modes 1 to 3, and what is left.
  const auto amplitudes = [&] {
    const ElasticModel& model = *elastic.model();
    std::vector<double> out(5, 0.0);
    for (std::size_t n = 0; n < model.network->nodes().size(); ++n) {
      const std::uint32_t atom = model.network->nodes()[n];
      const Vec3 moved = app.scene.atoms().seen()->spheres[atom].centre_A - rest[atom].centre_A;
      for (std::size_t k = 0; k < 3; ++k) out[k] += glm::dot(model.modes->mode(k)[n], moved);
      out[4] += glm::dot(moved, moved);
    }
    out[3] = std::sqrt(std::max(0.0, out[4] - out[0] * out[0] - out[1] * out[1] - out[2] * out[2]));
    out[4] = std::sqrt(out[4]);
    return out;
  };
  std::vector<double> a = amplitudes();
  REQUIRE(a[4] > 0.05);
  CHECK(std::abs(a[0]) > 0.01 * a[4]);
  CHECK(std::abs(a[2]) > 0.01 * a[4]);
  CHECK(std::abs(a[1]) < 1e-7);
  CHECK(a[3] < 1e-6);
  CHECK(user->text("mode/3") == "on");
  CHECK(user->text("mode/2") == "off");
  user->release();
  user->click("mode/3");
  user->frames(1);
  CHECK(elastic.feltModes() == std::vector<std::size_t>{0});
  user->point("view", 0.5, 0.5);
  user->press();
  user->frames(1200);
  a = amplitudes();
  REQUIRE(a[4] > 0.05);
  CHECK(std::abs(a[1]) + std::abs(a[2]) < 1e-3 * a[4]);
  user->release();
  user->click("mode/1");
  CHECK(elastic.feltModes().empty());
  elastic.feelMode(20, true);  // there are 20
  CHECK(elastic.feltModes().empty());
}

TEST_CASE("the second window takes the modes from the cache folder, and they are the same to the last bit") {
  const ScratchFolder scratch;
  ScriptedUser::Options options = smallWindow({});
  options.application.cache_folder = scratch.path / "cache";
  std::vector<std::shared_ptr<const NormalModes>> modes;
  std::vector<double> compliances[2];
  for (int k = 0; k < 2; ++k) {
    const auto user = startWith("1ubq", options);
    ElasticMolecule& elastic = user->app().extensions().movers.get<ElasticMolecule>();
    elastic.start();
    user->frames(5);
    REQUIRE(elastic.model());
    CHECK((elastic.progress() > 0.0) == (k == 0));
    modes.push_back(elastic.model()->modes);
    compliances[k] = elastic.model()->compliances_A2_mol_kcal;
    std::size_t kept = 0;
    for (const auto& file : fs::directory_iterator(options.application.cache_folder))
      kept += file.path().extension() == ".modes";
    CHECK(kept == 1);
  }
  CHECK(modes[0]->eigenvalues == modes[1]->eigenvalues);
  CHECK(modes[0]->vectors == modes[1]->vectors);
  CHECK(compliances[0] == compliances[1]);
}

TEST_CASE("a molecule too small for an elastic network says so with a remedy, and nothing moves") {
  const auto user = startWith("water", smallWindow({}));
  ElasticMolecule& elastic = user->app().extensions().movers.get<ElasticMolecule>();
  elastic.start();
  user->frames(5);
  CHECK_FALSE(elastic.model());
  CHECK(contains(elastic.problem(), "too few residues"));
  CHECK_FALSE(elastic.moving());
}

}  // namespace
}  // namespace moltact
