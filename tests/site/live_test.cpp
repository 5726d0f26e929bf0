// The live figures as their readers meet them, opened as files; what they show is computed again by the reference
// implementations, which nothing of the site may hold.
#include "checker/base/text.hpp"
#include "checker/data/reference_results.hpp"
#include "lectures/11_measured/throws.hpp"
#include "rigid/attitude_of_a_free_body.hpp"
#include "rigid/euler_angles.hpp"
#include "rigid/euler_equations.hpp"
#include "rigid/free_tops.hpp"
#include "rigid/heavy_top.hpp"
#include "rigid/inertia_tensor.hpp"
#include "rigid/parallel_axis.hpp"
#include "rigid/rotating_frames.hpp"
#include "tests/site/inspection.hpp"
#include "tests/support/files.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string_view>
#include <tuple>

using namespace workbook::site;
using nlohmann::json;
using namespace rigid;

namespace {

/// One browser for all cases.
Browser& browser() {
  static Browser the_browser(SITE_CHROMIUM);
  return the_browser;
}

void set_media(const json& features, const char* media = "") {
  browser().call("Emulation.setEmulatedMedia", {{"media", media}, {"features", features}});
}

void resize(int width) {
  browser().call("Emulation.setDeviceMetricsOverride",
                 {{"width", width}, {"height", 900}, {"deviceScaleFactor", 1}, {"mobile", false}});
}

/// Opens a page with the test's functions in it; returns how many live figures it has.
int open_page(const std::string& page) {
  resize(1280);
  browser().open("file://" SITE_NOTES "/" + page);
  return browser().evaluate(read_text(SITE_SCRIPTS "/live.js") + "; places.length");
}

std::vector<std::string> pages_with_figures() {
  std::vector<std::string> pages = pages_of(SITE_NOTES);
  std::erase_if(pages, [](const std::string& page) {
    return read_text(std::filesystem::path(SITE_NOTES) / page).find("<div class=\"live\"") == std::string::npos;
  });
  return pages;
}

json evaluate_in(int figure, const std::string& expression) {
  return browser().evaluate(
      fmt::format("((place, live) => {{ return {}; }})(places[{}], places[{}].live)", expression, figure, figure));
}

/// No request to another machine, no error.
void check_events() {
  for (const json& event : browser().take_events()) {
    if (event.value("/params/blockedReason"_json_pointer, "") == "inspector") continue;
    const std::string method = event["method"];
    if (method == "Network.requestWillBeSent") {
      const std::string url = event["params"]["request"]["url"];
      CHECK_MESSAGE((url.starts_with("file:") || url.starts_with("data:")), url);
    }
    CHECK_MESSAGE(method != "Network.loadingFailed", event.dump());
    CHECK_MESSAGE(method != "Runtime.exceptionThrown", event.dump());
    CHECK_MESSAGE((method != "Runtime.consoleAPICalled" || event["params"]["type"] != "error"), event.dump());
    CHECK_MESSAGE((method != "Log.entryAdded" || event["params"]["entry"]["level"] != "error"), event.dump());
  }
}

using Numbers = std::vector<double>;
using Values = std::map<std::string, double>;  // of the controls
constexpr double not_compared = NAN, degree = M_PI / 180;

Vector3d spin_of(const Values& v) { return {v.at("w1"), v.at("w2"), v.at("w3")}; }

Numbers numbers_of_free_body(const Values& v, double time) {
  const Vector3d I(v.at("I1"), v.at("I2"), v.at("I3")), omega0 = spin_of(v);
  const Vector3d omega = free_rotation(I, omega0, VectorXd::Constant(1, time)).col(0);
  const Vector2d invariants = rotation_invariants(I, omega0);
  std::array<int, 3> order = {0, 1, 2};
  std::ranges::stable_sort(order, {}, [&](int i) { return I[i]; });
  const Vector3d ascending(I[order[0]], I[order[1]], I[order[2]]);
  const double period = ascending[0] == ascending[2]
                            ? NAN
                            : tumbling_period(ascending, {omega0[order[0]], omega0[order[1]], omega0[order[2]]});
  return {omega[0], omega[1], omega[2], invariants[0], invariants[1], period};
}

/// What a figure shows at values of its controls and a time, in its order.
const std::map<std::string, std::function<Numbers(const Values&, double)>> numbers_of = {
    {"two_sources",
     [](const Values& v, double time) -> Numbers {
       const double omega = v.at("omega"), walk = v.at("walk"), out = v.at("start") + walk * time;
       const Vector3d along(std::cos(omega * time), std::sin(omega * time), 0), across(-along[1], along[0], 0);
       const Vector3d rate = walk * along + omega * out * across;
       return {std::abs(omega * out), rate.norm(), rate[0], rate[1], omega};
     }},
    {"book",
     [](const Values& v, double) -> Numbers {
       const double x = v.at("x") * degree, z = v.at("z") * degree;
       const Eigen::Quaterniond about_x(Eigen::AngleAxisd(x, Vector3d::UnitX())),
           about_z(Eigen::AngleAxisd(z, Vector3d::UnitZ()));
       const double apart = (about_z * about_x).angularDistance(about_x * about_z);
       return {apart, apart / std::abs(x * z)};
     }},
    {"puck",
     [](const Values& v, double time) -> Numbers {
       if (v.at("law") != 0) return {};  // no motion that there is
       const double sample = std::floor(40 * time) / 40, heading = v.at("heading") * degree;
       const Vector3d omega(0, 0, v.at("omega")),
           v0 = v.at("speed") * Vector3d(std::cos(heading), std::sin(heading), 0);
       const Eigen::AngleAxisd back(-omega[2] * sample, Vector3d::UnitZ());
       const Vector3d r = back * (Vector3d(v.at("start"), 0, 0) + v0 * sample), seen = back * v0 - omega.cross(r),
                      zero(0, 0, 0);
       return {fictitious_force(1, zero, seen, omega, zero).norm(), fictitious_force(1, r, zero, omega, zero).norm(),
               0};
     }},
    {"foucault",
     [](const Values& v, double) -> Numbers {
       const double latitude = v.at("latitude") * degree;
       return {latitude == 0 ? NAN : foucault_period(std::abs(latitude), 86164.0989), not_compared, not_compared};
     }},
    {"held_spin",
     [](const Values& v, double) -> Numbers {
       const double polar = v.at("polar") * degree, azimuth = v.at("azimuth") * degree;
       const Vector3d n(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), std::cos(polar));
       const Vector3d omega = v.at("rate") * n;
       const Matrix3d I = cuboid_about_center(1, v.at("a"), v.at("b"), v.at("c"));
       return {moment_about_axis(I, n),
               kinetic_energy(I, omega),
               angular_momentum(I, omega).norm(),
               torque_to_hold_rotation(I, omega).norm(),
               I(0, 0),
               I(1, 1),
               I(2, 2)};
     }},
    {"moving_point",
     [](const Values& v, double time) -> Numbers {
       const Vector3d point = time / 6 * Vector3d(v.at("x"), v.at("y"), v.at("z"));
       const Matrix3d I = inertia_about_shifted_origin(cuboid_about_corner(6, 1, 2, 3), 6, {0.5, 1, 1.5}, -point);
       const Vector3d moments = principal_moments(I);
       return {I(0, 0), I(1, 2), I(0, 1), moments[0], moments[1], moments[2]};
     }},
    {"integrators",
     [](const Values& v, double time) -> Numbers {
       return {not_compared, not_compared, free_rotation({1, 2, 3}, spin_of(v), VectorXd::Constant(1, time))(1, 0)};
     }},
    {"wheel",
     [](const Values& v, double) -> Numbers {
       const double I3 = v.at("wheel_mass") * 0.09, spin = v.at("spin"), rate = 9.81 * v.at("arm") / 0.09 / spin;
       return {I3 * std::abs(spin), gyroscopic_torque(I3 / 2, I3, spin, {rate, 0, 0}).norm(), rate,
               2 * M_PI / std::abs(rate)};
     }},
    {"t_handle",
     [](const Values& v, double time) -> Numbers {
       const Vector3d I(1, 2.2, 2.9);
       const double error = v.at("error") * degree, spin = v.at("spin");
       const Vector3d omega0(0, spin * std::cos(error), spin * std::sin(error));
       const Vector3d omega = free_rotation(I, omega0, VectorXd::Constant(1, time)).col(0);
       const double half = tumbling_period(I, omega0) / 2;
       return {omega[0], omega[1], omega[2], half, half * I.cwiseProduct(omega0).norm() / I[1] / (2 * M_PI)};
     }},
    {"plate",
     [](const Values& v, double) -> Numbers {
       const double tilt = v.at("tilt") * degree, ratio = v.at("ratio"), spin = v.at("spin");
       const double wobble = space_precession_rate(1, ratio, {0, ratio * spin * std::tan(tilt), spin});
       const double emblem = wobble - body_precession_rate(1, ratio, spin);
       return {wobble, emblem, wobble / emblem};
     }},
    {"friction",
     [](const Values& v, double time) -> Numbers {
       // By the midpoint rule with steps so small that it suffices.
       const Vector3d I(v.at("I1"), 2, 2.4);
       const double angle = v.at("angle") * degree, h = 2e-4;
       Vector3d L = 3 * Vector3d(std::cos(angle), 0.6 * std::sin(angle), 0.8 * std::sin(angle));
       const auto rate = [&](const Vector3d& now) -> Vector3d {
         const Vector3d across = now.cross(Vector3d(now.cwiseQuotient(I)));
         return across + v.at("kappa") / 3 * now.cross(across);
       };
       const double T0 = L.dot(L.cwiseQuotient(I)) / 2;
       for (int k = 0; k < static_cast<int>(std::round(20 * time)) * 250; ++k) L += h * rate(L + h / 2 * rate(L));
       const double T = L.dot(L.cwiseQuotient(I)) / 2;
       return {3, T, T0 - T, std::acos(std::min(1.0, std::abs(L[0]) / L.norm()))};
     }},
    {"free_body", numbers_of_free_body},
    {"rolling_cones", numbers_of_free_body},
    {"three_turns",
     [](const Values& v, double) -> Numbers {
       constexpr std::array<std::array<int, 3>, 3> axes = {{{2, 1, 2}, {2, 0, 2}, {2, 1, 0}}};
       Matrix3d A = Matrix3d::Identity();
       for (const auto& [turn, angle] : {std::pair{0U, "phi"}, {1U, "theta"}, {2U, "psi"}})
         A = A * Eigen::AngleAxisd(v.at(angle) * degree,
                                   Vector3d::Unit(axes.at(static_cast<std::size_t>(v.at("convention")))[turn]));
       return {not_compared, euler_angles(A.transpose())[1], not_compared, A(0, 2), A(1, 2), A(2, 2)};
     }},
    {"gimbal_passage",
     [](const Values& v, double time) -> Numbers {
       const double distance = v.at("distance") * degree, spin = v.at("spin");
       const Vector3d omega(0, std::cos(distance), std::sin(distance)), x(1, 0, 0), z(0, 0, 1);
       const Matrix3d carried =
           (Eigen::AngleAxisd(time - M_PI / 2, omega) * Eigen::AngleAxisd(distance, x)).toRotationMatrix();
       const Matrix3d A = carried * Eigen::AngleAxisd(spin * time, z);
       const Vector3d angles = euler_angles(A.transpose());
       const Vector3d rates = euler_angle_rates(angles, A.transpose() * (omega + spin * A.col(2)));
       return {not_compared, angles[1], not_compared, rates[0], rates[1], rates[2]};
     }},
    {"angles_and_momenta",
     [](const Values& v, double time) -> Numbers {
       const Vector3d I(v.at("I1"), v.at("I2"), v.at("I3"));
       const Vector3d upright = rotation_matrix({0, v.at("theta") * degree, v.at("psi") * degree}).col(2);
       const Vector3d omega0 = (v.at("L") * upright).cwiseQuotient(I);
       const VectorXd sample = VectorXd::Constant(1, std::round(25 * time) / 25);
       return {rotation_invariants(I, omega0)[0], v.at("L"), 0, I[2] * free_rotation(I, omega0, sample)(2, 0)};
     }},
    {"heavy_top",
     [](const Values& v, double time) -> Numbers {
       constexpr double I1 = 3.28e-4, I3 = 6.6e-5, mgl = 0.0456;
       const double tilt = v.at("theta") * degree, push = v.at("push"), spin = v.at("spin");
       const Vector3d rates(push, 0, spin - push * std::cos(tilt));
       const Vector2d limits = nutation_limits(I1, I3, mgl, tilt, rates);
       const bool is_fast = spin > 2.02 * std::sqrt(I1 * mgl * std::cos(tilt)) / I3;
       return {limits[0],
               limits[1],
               nutation_period(I1, I3, mgl, tilt, rates),
               precession_per_nutation(I1, I3, mgl, tilt, rates),
               is_fast ? steady_precession(I1, I3, mgl, spin, tilt)[0] : NAN,
               spin * std::exp(-v.at("loss") * std::round(250 * time) / 250),  // at the nearest sample of the motion
               sleeping_spin(I1, I3, mgl)};
     }},
    {"replayed_throw",
     [](const Values& v, double time) -> Numbers {
       const measured::Flight flight = measured::racket_throws()[v.at("which") == 0 ? 5 : 2];
       const Vector3d I(1, v.at("Iy"), v.at("Iz"));
       const Vector3d start = measured::fitted_start(
           flight, [&](const Vector3d& from) { return measured::motion_in_air(I, flight.t, from, v.at("gamma")); });
       Matrix3Xd left = -flight.omega;
       for (Eigen::Index k = 0; k < left.cols(); ++k)
         left.col(k) += damped_rotation(I, start, v.at("gamma"), flight.t[k] - flight.t[0]);
       const auto last = static_cast<double>(flight.t.size() - 1);
       const auto k = static_cast<Eigen::Index>(time / (flight.t[flight.t.size() - 1] - flight.t[0]) * last + 1e-6);
       const Vector3d omega = flight.omega.col(k), L = I.cwiseProduct(omega),
                      L0 = I.cwiseProduct(Vector3d(flight.omega.col(0)));
       const Matrix3d A = attitude_from_rates(flight.t.head(k + 1), flight.omega.leftCols(k + 1));
       return {measured::root_mean_square(left),
               omega[0],
               omega[1],
               omega[2],
               L.norm() / L0.norm(),
               std::acos(std::min(1.0, (A * L).normalized().dot(L0.normalized())))};
     }},
    {"herpolhode", [](const Values& v, double time) -> Numbers {
       const Vector3d I(1.2, 2, 2.7), omega0 = spin_of(v);
       const Vector2d contact = poinsot(I, free_rotation(I, omega0, VectorXd::Constant(1, time)).col(0));
       return {contact[0], contact[1], tumbling_period(I, omega0), turn_per_period(I, omega0),
               geometric_phase(I, omega0)};
     }}};

/// The numbers on display are those of the course, to what four digits show.
void check_numbers(int figure, const std::string& name) {
  std::size_t compared = 0;
  for (const json& setting : browser().evaluate(fmt::format("settings_of({})", figure))) {
    CAPTURE(setting.dump());
    CHECK(setting["left_handed"].empty());
    const Numbers expected = numbers_of.at(name)(setting["values"].get<Values>(), setting["time"]);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const json& shown = setting["numbers"][i];
      if (shown.is_null() || std::isnan(expected[i])) continue;  // not finite: shown as a dash
      ++compared;
      CHECK_MESSAGE(std::abs(shown.get<double>() - expected[i]) <= 3e-4 * std::max(0.3, std::abs(expected[i])), name,
                    ", number ", i, ": ", shown.dump(), " and not ", expected[i]);
    }
  }
  CHECK(compared >= 5);
}

/// Keys turn a scene, move a slider and the ring; so does the pointer, and the ring follows it.
void check_input(int figure) {
  constexpr int shift = 8;
  const auto key = [](const char* name, int code, int modifiers = 0) {
    for (const char* type : {"rawKeyDown", "keyUp"})
      browser().call(
          "Input.dispatchKeyEvent",
          {{"type", type}, {"key", name}, {"code", name}, {"windowsVirtualKeyCode", code}, {"modifiers", modifiers}});
  };
  evaluate_in(figure, "live.begin_with()");
  const auto changes = [&](const std::string& what, const std::function<void()>& act) {
    const json before = evaluate_in(figure, what);
    act();
    CHECK_MESSAGE(before != evaluate_in(figure, what), what);
  };
  changes("live.values", [&] {
    evaluate_in(figure, "place.querySelector('.settings input').focus()");
    const bool is_last = evaluate_in(figure, "document.activeElement.value === document.activeElement.max");
    is_last ? key("ArrowLeft", 37) : key("ArrowRight", 39);
  });
  const auto drag = [&](const json& at, double right, double down) {
    for (const auto& [type, part] : {std::pair{"mousePressed", 0}, {"mouseMoved", 1}, {"mouseReleased", 1}})
      browser().call("Input.dispatchMouseEvent", {{"type", type},
                                                  {"x", at[0].get<double>() + part * right},
                                                  {"y", at[1].get<double>() + part * down},
                                                  {"button", "left"},
                                                  {"clickCount", 1}});
  };
  const auto ring = [&] {
    return evaluate_in(figure,
                       "(({scene}) => { const box = box_of(scene.canvas);"
                       " const [x, y] = scene.at(live.definition.handle(live.values));"
                       " return [box.x + x, box.y + y]; })(live.scenes.find(({view}) => view.handle))");
  };
  // One value may move the ring along a line only, and it may stand at the end of its range.
  double nearest = 1;
  bool keys_move_it = false;
  for (const auto& [right, down, name, code] : {std::tuple{40, 40, "ArrowRight", 39},
                                                {-40, 40, "ArrowLeft", 37},
                                                {-40, -40, "ArrowUp", 38},
                                                {40, -40, "ArrowDown", 40}}) {
    evaluate_in(figure, "live.begin_with()");
    const json from = ring();
    drag(from, right, down);
    const json to = ring();
    nearest = std::min(nearest, std::hypot(to[0].get<double>() - from[0].get<double>() - right,
                                           to[1].get<double>() - from[1].get<double>() - down) /
                                    std::hypot(right, down));
    evaluate_in(figure, "live.begin_with()");
    const json before = evaluate_in(figure, "live.values");
    evaluate_in(figure, "live.scenes.find(({view}) => view.handle).scene.canvas.focus()");
    key(name, code, shift);
    keys_move_it = keys_move_it || before != evaluate_in(figure, "live.values");
  }
  CHECK(nearest < 0.95);
  CHECK(keys_move_it);
  if (!evaluate_in(figure, "live.scenes.some(({scene}) => !scene.flat)")) return;
  const std::string canvas = "live.scenes.find(({scene}) => !scene.flat).scene.canvas";
  changes("pictures(live)", [&] {
    evaluate_in(figure, canvas + ".focus()");
    key("ArrowRight", 39);
  });
  changes("pictures(live)",
          [&] { drag(evaluate_in(figure, "(box => [box.x + 50, box.y + 10])(box_of(" + canvas + "))"), -40, 40); });
}

/// axe-core finds no fault with open figures; in the dark only the colours differ.
void check_accessibility() {
  browser().evaluate(read_text(SITE_AXE) + ";null");
  for (const auto& [colors, rules] : {std::pair{"light", ""}, {"dark", ", runOnly: ['color-contrast']"}}) {
    set_media({{{"name", "prefers-color-scheme"}, {"value", colors}}});
    const json violations = browser().evaluate(
        fmt::format("axe.run('.live', {{ resultTypes: ['violations'], preload: false{} }})", rules) +
        ".then(report => report.violations.map(found => found.id + ': ' + found.nodes[0].html.slice(0, 200)))");
    CHECK_MESSAGE(violations.empty(), violations.dump());
  }
  set_media(json::array());
}

}  // namespace

TEST_CASE("every live figure starts, runs, rests, obeys, and shows what the functions of the course give") {
  const std::vector<std::string> pages = pages_with_figures();
  REQUIRE(!pages.empty());
  bool judged = false;
  for (const std::string& page : pages) {
    browser().take_events();
    const int count = open_page(page);
    // Nothing is loaded for figures that are out of sight.
    CHECK(browser().evaluate("places.some(place => place.closest('figure').getBoundingClientRect().top < 1100) || "
                             "![...document.scripts].some(script => script.src.endsWith('/live/live.js'))") == true);
    for (int figure = 0; figure < count; ++figure) {
      const std::string name = browser().evaluate(fmt::format("places[{}].dataset.figure", figure));
      CAPTURE(name);
      const double started = browser().evaluate(fmt::format("open_figure({})", figure));
      const json run = browser().evaluate(fmt::format("run_figure({}, {})", figure, page == pages.front()));
      for (const json& fault : run["faults"]) CHECK_MESSAGE(false, fault.dump());
      const json words = browser().evaluate(fmt::format("faults_of_words({})", figure));
      CHECK_MESSAGE(words.empty(), words.dump());
      fmt::print("{:<20} started after {:4.0f} ms, {:3.0f} frames per second\n", name, started,
                 run["rate"].get<double>());
      check_numbers(figure, name);
      check_input(figure);
    }
    resize(390);
    for (int figure = 0; figure < count; ++figure) {
      CHECK(browser().evaluate(fmt::format("fits({})", figure)) == true);
      // Who sets the figure sees its first picture.
      evaluate_in(figure, "place.querySelector('.settings').scrollIntoView({ block: 'end', behavior: 'instant' })");
      CHECK(evaluate_in(figure, "place.querySelector('canvas').getBoundingClientRect().top > 0") == true);
    }
    // Figures are made alike: only the first with every kind of control is judged whole.
    if (!judged && !std::string_view(SITE_AXE).empty() &&
        browser().evaluate("!!document.querySelector('.live select')")) {
      check_accessibility();
      judged = true;
    }
    check_events();
  }
}

TEST_CASE("words that only the still picture makes true, a missing reason, and a left-handed frame are found") {
  open_page("lecture_10_attitude_of_a_free_body.html");
  browser().evaluate("open_figure(0)");
  const auto said_of = [](const char* change) {
    return browser().evaluate(fmt::format("{}; faults_of_words(0).join()", change)).get<std::string>();
  };
  const std::string caption = "document.querySelector('.live-caption').textContent = ";
  CHECK(said_of((caption + "'Left: the red dot.'").c_str()) == "says “Left”");
  CHECK(said_of((caption + "'One motion, dashed.'").c_str()) == "says “dashed”");
  CHECK(said_of((caption + "''").c_str()) == "has no caption of its own");
  CHECK(said_of((caption + "'One motion.'").c_str()).empty());
  CHECK(said_of("places[0].live.definition.choices['at the same place'] = 'Yes: so it is.'")
            .find("whether it is right") != std::string::npos);

  open_page("lecture_06_free_tops_exact.html");
  browser().evaluate("open_figure(0)");
  CHECK(browser().evaluate("left_handed(0)").empty());
  CHECK(browser().evaluate("left_handed(0, ([x, y, z]) => [x, -y, z])").size() == 2);  // in the body and in space
}

TEST_CASE(
    "a Foucault pendulum goes round anticlockwise in the south, in the same time, and on the equator not at all") {
  open_page("lecture_02_rotating_frames.html");
  browser().evaluate("open_figure(1)");
  const auto shown_at = [](int latitude) {
    return evaluate_in(1, fmt::format("(live.set({{ latitude: {} }}), live.list.firstChild.textContent)", latitude))
        .get<std::string>();
  };
  CHECK(shown_at(30) == "Earth: clockwise in47.87 h");
  CHECK(shown_at(-30) == "Earth: anticlockwise in47.87 h");
  CHECK(shown_at(0) == "Earth: no turn– h");
}

TEST_CASE("nothing moves on a page once it is seen") {
  for (const std::string page : {"index.html", "lecture_04_parallel_axis.html", "lecture_06_free_tops_exact.html"})
    for (const int width : {1280, 390}) {
      open_page(page);
      resize(width);
      browser().open(fmt::format("file://" SITE_NOTES "/{}", page));
      const double moved = browser().evaluate(R"js((async () => {
        let total = 0;
        new PerformanceObserver(list => list.getEntries().forEach(({ value }) => total += value))
          .observe({ type: "layout-shift", buffered: true });
        await new Promise(done => setTimeout(done, 1500));
        return total;
      })())js");
      CHECK_MESSAGE(moved < 0.001, page, " at ", width, " pixels");
    }
}

TEST_CASE("a still figure in space turns with its texts, from where the still picture shows it") {
  int figures = 0;
  for (const std::string& page : pages_of(SITE_NOTES)) {
    if (read_text(std::filesystem::path(SITE_NOTES) / page).find("<metadata>") == std::string::npos) continue;
    open_page(page);
    const int count = browser().evaluate("document.querySelectorAll('svg.turns').length");
    for (int i = 0; i < count; ++i, ++figures) {
      const json seen = browser().evaluate(fmt::format("turned_still(document.querySelectorAll('svg.turns')[{}])", i));
      CAPTURE(page);
      CAPTURE(seen.dump());
      CHECK(seen["is_drawn"] == true);
      CHECK(seen["covered"] > 0.97);
      CHECK(seen["first"] < 0.01);
      CHECK(seen["then"] > 5);
    }
    check_events();
  }
  CHECK(figures > 20);
}

TEST_CASE("on paper, and without JavaScript, the still picture stays with its caption") {
  const std::string page = pages_with_figures().front();
  const std::string still_height = "document.querySelector('figure:has(> .live) > svg').getBoundingClientRect().height";
  const std::string captions =
      "[...document.querySelector('figure:has(> .live) > figcaption').children]"
      ".map(caption => caption.getBoundingClientRect().height > 5).join()";
  open_page(page);
  browser().evaluate("open_figure(0)");
  CHECK(browser().evaluate(still_height) == 0);
  CHECK(browser().evaluate(captions) == "false,false");
  evaluate_in(0, "place.querySelector('.question button').click()");
  CHECK(browser().evaluate(captions) == "false,true");
  set_media(json::array(), "print");
  CHECK(browser().evaluate(still_height) > 20);
  CHECK(browser().evaluate(captions) == "true,false");
  CHECK(browser().evaluate("places[0].getBoundingClientRect().height") == 0);
  set_media(json::array());
  browser().call("Emulation.setScriptExecutionDisabled", {{"value", true}});
  browser().open("file://" SITE_NOTES "/" + page);
  CHECK(browser().evaluate(still_height) > 20);
  CHECK(browser().evaluate(captions) == "true,false");
  browser().call("Emulation.setScriptExecutionDisabled", {{"value", false}});
  check_events();
}

TEST_CASE("the time is moved in a plot and in steps, values go back, and an address restores the state") {
  const std::string page = "lecture_06_free_tops_exact.html";
  open_page(page);
  browser().evaluate("open_figure(0)");
  evaluate_in(0, "place.querySelector('.question button').click(), live.play(false)");
  const json plot = evaluate_in(0,
                                "(canvas => (box => [box.x + box.width / 2, box.y + box.height / 2])(box_of(canvas)))"
                                "(live.scenes.at(-1).scene.canvas)");
  for (const char* type : {"mousePressed", "mouseReleased"})
    browser().call("Input.dispatchMouseEvent",
                   {{"type", type}, {"x", plot[0]}, {"y", plot[1]}, {"button", "left"}, {"clickCount", 1}});
  const auto part_of_time = [] { return evaluate_in(0, "live.time / live.end").get<double>(); };
  CHECK(part_of_time() == doctest::Approx(0.48).epsilon(0.05));
  evaluate_in(0, "live.move_to(0), live.step(3)");
  CHECK(part_of_time() == doctest::Approx(0.03));
  CHECK(evaluate_in(0, "(live.set({ w1: 1.5 }, 'w1'), live.values.w1)") == 1.5);
  evaluate_in(0, "live.move_to(2), live.scenes[1].scene.turn(0.5, 0)");
  const json direction = evaluate_in(0, "live.scenes[1].scene.azimuth.toFixed(2)");
  const std::string address = evaluate_in(0, "live.address()");
  evaluate_in(0, "place.querySelectorAll('.settings input[type=range]')[3].dispatchEvent(new Event('dblclick'))");
  CHECK(evaluate_in(0, "live.values.w1") == 0);
  evaluate_in(0, "(live.set({ I1: 2 }, 'I1'), place.querySelector('[title^=\"As at\"]').click())");
  CHECK(evaluate_in(0, "live.values.I1") == 1);
  // At its end the motion stops, or begins anew where that was asked for.
  const auto runs_on = [] {
    return evaluate_in(0,
                       "(async () => { live.move_to(live.end - 0.001); live.play(true); for (let k = 0; k < 100; ++k) {"
                       " await wait(20); if (!live.playing || live.time < live.end / 2) break; }"
                       " return live.playing; })()");
  };
  CHECK(runs_on() == false);
  CHECK(evaluate_in(0, "live.again_button.ariaPressed") == "false");
  evaluate_in(0, "live.again_button.click()");
  CHECK(evaluate_in(0, "live.again_button.ariaPressed") == "true");
  CHECK(runs_on() == true);
  CHECK(evaluate_in(0, "(live.play(false), live.speeds.value = 0.5, live.speeds.onchange(), live.address())")
            .get<std::string>()
            .find("&speed=0.5&again=1&view=") != std::string::npos);
  // Another page first: an address that differs only behind the # loads nothing.
  open_page("index.html");
  open_page(page + address.substr(address.find('#')) + "&w2=99&speed=0.25&again=1");
  browser().evaluate("open_figure(0)");
  CHECK(evaluate_in(0,
                    "[live.values.w1, live.values.w2, live.time, live.speed, live.again,"
                    " live.scenes[0].scene.released]") == json({1.5, 4, 2, 0.25, true, false}));
  CHECK(evaluate_in(0, "live.scenes[1].scene.azimuth.toFixed(2)") == direction);
  open_page("lecture_02_rotating_frames.html#live=puck&heading=190&speed=99");
  browser().evaluate("open_figure(0)");
  CHECK(evaluate_in(0, "[live.values.heading, live.speed]") == json({-170, 1}));
}

TEST_CASE("words of a sentence set the figure they speak of, also before it is in sight") {
  open_page("lecture_05_euler_equations.html");
  browser().evaluate(
      "[...document.querySelectorAll('button.sets')].find(words => words.textContent === 'slowly').click()");
  CHECK(browser().evaluate(
            "(async () => { for (let k = 0; k < 500 && places[0].live?.values.spin !== 12; ++k) await wait(10);"
            " return places[0].live.values.spin; })()") == 12);
}

TEST_CASE("where nothing can be drawn in space, the still picture stays, and a sentence says why") {
  const std::string page = "lecture_06_free_tops_exact.html";
  const json id = browser().call("Page.addScriptToEvaluateOnNewDocument",
                                 {{"source", "HTMLCanvasElement.prototype.getContext = () => null;"}});
  open_page(page);
  browser().evaluate("places[0].scrollIntoView({ behavior: 'instant' })");
  CHECK(browser()
            .evaluate("(async () => { for (let k = 0; k < 500 && !places[0].textContent; ++k) await wait(10);"
                      " return places[0].textContent; })()")
            .get<std::string>()
            .find("WebGL 2") != std::string::npos);
  CHECK(browser().evaluate("document.querySelector('figure:has(> .live) > svg').getBoundingClientRect().height") > 20);
  browser().call("Page.removeScriptToEvaluateOnNewDocument", id);
}

TEST_CASE("where motion is to be reduced, an answer alone moves nothing") {
  set_media({{{"name", "prefers-reduced-motion"}, {"value", "reduce"}}});
  open_page(pages_with_figures().front());
  browser().evaluate("open_figure(0)");
  evaluate_in(0, "place.querySelector('.question button').click()");
  CHECK(evaluate_in(0, "live.playing") == false);
  CHECK(evaluate_in(0, "live.settings.disabled") == false);
  set_media(json::array());
}

TEST_CASE("nothing of the site computes what is asked for") {
  std::vector<std::string> names;
  for (const auto& file : workbook::testing::files_below(SITE_NOTES)) {
    if (file.filename() == "student.js") continue;  // the reader's own, from `checker live`
    const std::string text = read_text(file);
    CHECK_MESSAGE(!workbook::testing::holds_webassembly(text), file.string());
    if (file.parent_path().filename() != "live" || file.extension() != ".js") continue;
    for (const std::string& line : workbook::lines_of(text))
      if (const workbook::Match found = workbook::search(line, R"(^(?:const|let|var|class|(?:async )?function) (\w+))"))
        names.push_back(found[1]);
  }
  REQUIRE(names.size() > 30);

  json exercises = json::array(), problems = json::array();
  for (const auto& card : workbook::testing::files_below(SITE_LECTURES)) {
    if (card.filename() != "card.json") continue;
    const auto lecture = card.parent_path().filename().string();
    const auto reference =
        workbook::read_reference_results(std::filesystem::path(SITE_REFERENCES) / (lecture + ".json"));
    const json content = json::parse(read_text(card));
    for (const json& entry : content["exercises"]) {
      exercises.push_back(entry["name"]);
      if (!entry.contains("problem")) continue;
      json cases = json::array();
      for (const auto& one : reference.exercise(entry["name"]).cases)
        if (one.group == workbook::Group::random)
          cases.push_back(
              {{"inputs", one.inputs}, {"expected", one.expected}, {"size", *std::ranges::max_element(one.scale)}});
      REQUIRE(!cases.empty());
      problems.push_back({{"name", entry["name"]}, {"cases", cases}});
    }
  }
  CHECK(problems.size() >= 40);
  const auto thefts = [&] {
    json found = json::array();
    for (const json& problem : problems)
      for (const json& name :
           browser().evaluate(fmt::format("solutions_among({}, {})", json(names).dump(), problem["cases"].dump())))
        found.push_back(fmt::format("{} solves {}", name.get<std::string>(), problem["name"].get<std::string>()));
    return found;
  };
  for (const std::string& page : pages_with_figures()) {
    open_page(page);
    browser().evaluate("open_figure(0)");
    CHECK(browser().evaluate(fmt::format("functions_among({}).length", json(names).dump())) > 20);
    const json found = thefts();
    CHECK_MESSAGE(found.empty(), page, ": ", found.dump());
    const json exposed = browser().evaluate(exercises.dump() +
                                            ".filter(name => typeof globalThis[name] === 'function' || name in yours)");
    CHECK_MESSAGE(exposed.empty(), exposed.dump());
  }
  // What would be there under another name is found.
  browser().evaluate(
      "yours.spun = (radius, g, inclination) => 2 * Math.sqrt(g / radius / Math.sin(inclination)), null");
  CHECK(thefts() == json::array({"yours.spun solves spinning_coin"}));
}
