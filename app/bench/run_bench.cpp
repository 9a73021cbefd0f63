#include "app/bench/run_bench.h"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>

#include "app/commands/command.h"
#include "app/commands/device_path.h"
#include "app/commands/outputs.h"
#include "engine/bench/bodies/body_matrix.h"
#include "engine/bench/bodies/body_trade_off.h"
#include "engine/bench/charts.h"
#include "engine/bench/cold_cache_ticks.h"
#include "engine/bench/energies/energy_trade_off.h"
#include "engine/bench/energies/field_matrix.h"
#include "engine/bench/energies/page_ticks.h"
#include "engine/bench/feel.h"
#include "engine/bench/felt.h"
#include "engine/bench/hand_replay.h"
#include "engine/bench/hip_paths.h"
#include "engine/bench/many_threads.h"
#include "engine/bench/methods/bench_methods.h"
#include "engine/bench/methods/body_methods.h"
#include "engine/bench/report_table.h"
#include "engine/bench/smaller_probe.h"
#include "engine/bench/stability.h"
#include "engine/bench/stiffness.h"
#include "engine/bench/tables.h"
#include "engine/bench/trade_off.h"
#include "engine/bench/trade_off_sentences.h"
#include "engine/language/catalogue.h"
#include "engine/molecule/catalogue.h"
#include "engine/platform/folders.h"
#include "engine/platform/read_file.h"
#include "engine/platform/terminal.h"
#include "engine/platform/write_file.h"

namespace moltact {
namespace {

using namespace bench;
namespace fs = std::filesystem;

constexpr std::size_t kChartSpheres = 13'751;  // as many atoms as the paper's largest structure

// The measured results, in the order in which they are shown.
struct Report {
  std::vector<ReportTable> tables;
  std::vector<ReportTable> excerpts;                           // parts of long tables; only for the pages
  std::vector<std::pair<std::string, std::string>> pictures;   // file name, SVG
  std::vector<std::pair<std::string, std::string>> sentences;  // marker's name, Markdown that summarizes the tables
};

class ProgressBar {
 public:
  explicit ProgressBar(std::string part) : part_(std::move(part)) {}
  ~ProgressBar() { showStatus({}); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void operator()(double share, std::string_view what) const {
    constexpr int kWidth = 30;
    const int full = static_cast<int>(share * kWidth);
    showStatus(part_ + " [" + std::string(std::size_t(full), '#') + std::string(std::size_t(kWidth - full), '.') +
               "] " + std::to_string(static_cast<int>(100 * share)) + " %  " + std::string(what));
  }

 private:
  std::string part_;
};

void makeFolderOf(const fs::path& file) {
  std::error_code error;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
}

void write(const fs::path& file, const std::string& text) {
  makeFolderOf(file);
  if (const auto problem = writeWhole(file, text)) throw CommandError{problem->text()};
}

// Fails if write() would fail for lack of a folder or permission. An existing file stays unchanged.
void tryWriting(const fs::path& file) {
  makeFolderOf(file);
  if (const auto draft = Draft::begin(file); !draft) throw CommandError{draft.problem().text()};
}

void checkPages(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw CommandError{
        Problem{folder.string(), 0, 0, tr("there is no such folder"), tr("name the folder of the pages, such as docs")}
            .text()};
}

// The names of --methods denote methods for a probe or for a body.
void checkNames(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (findBenchMethod(name) || findBodyMethod(name)) continue;
    std::string known;
    for (const Method& m : benchMethods()) known.append(known.empty() ? "" : ", ").append(m.name);
    for (const BodyMethod& m : bodyMethods()) known.append(", ").append(m.name);
    throw CommandError{
        Problem{"--methods", 0, 0, trf("there is no method \"{0}\"", name), trf("choose from {0}", known)}.text()};
  }
}

std::vector<const Method*> chosen(const std::vector<std::string>& names, bool quick) {
  // These finer methods take seconds to prepare a whole scene. They run only in full runs or when they are named.
  constexpr std::string_view kNotQuick[] = {"grid02-ready", "sasmesh025"};
  std::vector<const Method*> out;
  for (const Method& m : benchMethods())
    if ((names.empty() && !(quick && std::ranges::find(kNotQuick, m.name) != std::end(kNotQuick))) || isReference(m) ||
        std::find(names.begin(), names.end(), m.name) != names.end())
      out.push_back(&m);
  return out;
}

std::vector<const BodyMethod*> chosenForBodies(const std::vector<std::string>& names) {
  std::vector<const BodyMethod*> out;
  for (const BodyMethod& m : bodyMethods())
    if (names.empty() || m.reference || std::find(names.begin(), names.end(), m.name) != names.end()) out.push_back(&m);
  return out;
}

// The stability bench creates thousands of trackers and changes the probe during contact. It covers only methods that
// need no preparation. Its scenes are rotated, so a method that feels from above only is judged where `named` asks for it.
std::vector<const Method*> unlimited(std::vector<const Method*> methods, const std::vector<std::string>& named) {
  std::erase_if(methods, [&](const Method* m) {
    const bool asked = std::find(named.begin(), named.end(), m->name) != named.end();
    return !limitsOf(*m).none() || (limitsOf(*m).from_above && !asked);
  });
  return methods;
}

// The structures that the library holds or the user has fetched; missing ones are skipped.
std::vector<TableScene> structures() {
  std::vector<TableScene> out;
  const MoleculeFolders folders = MoleculeFolders::ofThisComputer();
  const auto add = [&](const std::string& id, const std::string& paper) {
    if (!findMolecule(id, folders)) return;
    const auto molecule = openMolecule(id);
    if (!molecule) return;
    out.push_back(
        {molecule->id, molecule->atoms.size(), [spheres = molecule->spheres.copy()] { return spheres; }, paper});
  };
  add("1ubq", "");
  add("2hhb", "");
  for (const char* id : {"5ADH", "8TIM", "1KBW"}) add(id, id);
  return out;
}

// Reports an unwritable folder before anything is measured, because the bench can take a quarter of an hour.
void tryOutputs(const BenchArguments& arguments) {
  if (!arguments.recordings.empty() && arguments.part != "hands" && arguments.part != "all")
    throw CommandError{Problem{"--recording", 0, 0, trf("the part {0} uses no recorded hands", arguments.part),
                               tr("leave it out, or measure the part hands")}
                           .text()};
  for (const std::string& file : arguments.recordings) noteRead(file);
  checkOutputs({{"--json", arguments.json}, {"--markdown", arguments.markdown}});
  if (!arguments.svg.empty() && !arguments.docs.empty() &&
      sameFile(arguments.svg, fs::path(arguments.docs) / "pictures"))
    throw CommandError{Problem{arguments.svg, 0, 0, trf("{0} and {1} would write the same charts", "--svg", "--docs"),
                               tr("leave --svg out")}
                           .text()};
  if (!arguments.docs.empty()) checkPages(arguments.docs);
  for (const std::string& file : {arguments.json, arguments.markdown})
    if (!file.empty()) tryWriting(file);
  for (const std::string& folder : {arguments.csv, arguments.svg})
    if (!folder.empty()) tryWriting(fs::path(folder) / "moltact-bench.tmp");
}

StrokePlan plan(const BenchArguments& arguments) {
  StrokePlan p;
  p.strokes = arguments.quick ? 16 : 80;
  p.ticks = arguments.quick ? 2000 : 4000;
  p.seed = arguments.seed;
  return p;
}

// Measured on the spheres of the chart, and shown beside the same methods' consecutive ticks.
void addCool(const BenchArguments& arguments, const std::vector<const Method*>& methods,
             const std::vector<SceneTimes>& times, Report& report) {
  const auto scene =
      std::make_shared<const SphereGrid>(proteinLike(kChartSpheres, static_cast<unsigned>(arguments.seed)));
  StrokePlan strokes = plan(arguments);
  strokes.strokes = 4;
  const ColdCachePlan ticks = arguments.quick ? ColdCachePlan{100, 24} : ColdCachePlan{1000, 200};
  const ProgressBar bar("caches");
  const auto cool = timeColdCache(methodsForSize(methods, kChartSpheres), scene, kWaterProbe_A,
                                  contactStrokes(scene, kWaterProbe_A, strokes), ticks, std::cref(bar));
  const auto hot =
      std::find_if(times.begin(), times.end(), [&](const SceneTimes& s) { return s.spheres == kChartSpheres; });
  report.tables.push_back(
      coldCacheTable(cool, hot == times.end() ? std::vector<TickTimes>{} : hot->contact, kChartSpheres));
  report.sentences.push_back({"cool_sentences", coldCacheSentences(cool)});
}

void addTables(const BenchArguments& arguments, const std::vector<const Method*>& methods, Report& report) {
  std::vector<TableScene> scenes = madeScenes(arguments.quick, arguments.seed);
  for (TableScene& one : structures()) scenes.push_back(std::move(one));
  TableOptions options{methods, kWaterProbe_A, plan(arguments), arguments.quick ? 0.1 : 1.0,
                       arguments.quick ? std::size_t(kChartSpheres) : 0};
  const ProgressBar bar("tables");
  const auto times = measureTables(scenes, options, std::cref(bar));
  report.tables.push_back(paperComparisonTable(times));
  report.tables.push_back(tickTable(times));
  report.tables.push_back(readyTable(times));
  for (const auto& [name, table] : {std::pair{"ticks", tickTable(times)}, std::pair{"ready", readyTable(times)}}) {
    report.excerpts.push_back(
        rowsWhere(table, "scene", "13 800 protein-like", std::string(name) + "_13800", table.title));
    report.excerpts.push_back(
        rowsWhere(table, "method", std::string(referenceMethod().name), std::string(name) + "_exact", table.title));
  }
  report.pictures.push_back({"memory-and-ready-time.svg", sizeChart(times)});
  report.sentences.push_back({"size_sentences", sizeSentences(times)});
  addCool(arguments, methods, times, report);
}

void addChart(const BenchArguments& arguments, const std::vector<const Method*>& methods, Report& report) {
  TradeOffOptions options;
  options.methods = methods;
  options.plan = plan(arguments);
  options.budget_s = arguments.quick ? 0.1 : 2.0;
  options.seed = arguments.seed;
  const ProgressBar bar("chart");
  const auto points = measureTradeOffs(options, std::cref(bar));
  report.tables.push_back(tradeOffTable(points, options));
  report.sentences.push_back({"trade_off_sentences", tradeOffSentences(points)});
  report.pictures.push_back({"speed-and-accuracy.svg", tradeOffChart(points, options.spheres)});
}

// Placed right after `exact`, whose measure it is.
std::vector<const Method*> withNoiseFloor(std::vector<const Method*> methods) {
  auto at = methods.begin() + 1;
  for (const Method& floor : noiseFloor()) at = methods.insert(at, &floor) + 1;
  return methods;
}

void addStability(const BenchArguments& arguments, const std::vector<const Method*>& methods, Report& report) {
  StabilityOptions options;
  options.methods = withNoiseFloor(methods);
  options.seed = arguments.seed;
  options.draws = arguments.quick ? 2 : 30;
  const ProgressBar bar("stability");
  const auto all = measureStability(options, std::cref(bar));
  for (const bool changing : {false, true}) {
    const auto results = resultsWhere(all, changing);
    const auto cells = stabilityCells(results);
    const std::string begins = changing ? "changing_" : "",
                      adds = changing ? ", where the surface moves or has friction" : "";
    for (ReportTable table : {fidelityMatrix(cells), stabilityMatrix(cells), stabilitySummary(results)}) {
      table.name = begins + table.name;
      table.title += adds;
      report.tables.push_back(std::move(table));
    }
    report.sentences.push_back({begins + "stability_sentences", stabilitySentences(results)});
  }
  report.tables.push_back(stabilityFigures(all));
  StiffnessOptions stiffness;
  stiffness.methods = methods;
  stiffness.directions = arguments.quick ? 1 : 12;
  stiffness.seed = arguments.seed;
  const auto limits = measureStiffness(stiffness, std::cref(bar));
  report.excerpts.push_back(deviceTable(options.loop));
  report.excerpts.push_back(stiffnessSetupsTable());
  report.tables.push_back(stiffnessTable(limits));
  report.tables.push_back(stiffnessFigures(limits));
  report.sentences.push_back({"stiffness_sentences", stiffnessSentences(limits)});
}

void addFeel(const BenchArguments& arguments, const std::vector<const Method*>& methods, Report& report) {
  const ProgressBar bar("feel");
  bar(0, "");
  report.tables.push_back(feelTable(measureFeel(methods)));
  const auto scene = std::make_shared<const SphereGrid>(proteinLike(13'751, static_cast<unsigned>(arguments.seed)));
  StrokePlan strokes = plan(arguments);
  strokes.strokes /= 2;
  const auto made = contactStrokes(scene, kWaterProbe_A, strokes);
  const std::vector<const Method*> judged = withNoiseFloor(methods);
  std::vector<FeltErrors> felt(judged.size());
  inManyThreads(
      judged.size(), [&](std::size_t k) { felt[k] = feltOn("made strokes", *judged[k], scene, kWaterProbe_A, made); },
      [&](std::size_t done) { bar(double(done) / double(judged.size()), ""); });
  report.tables.push_back(
      feltTable("felt", "What a hand could tell, on " + std::to_string(made.size()) + " made strokes", felt));
  report.sentences.push_back({"felt_sentences", feltSentences(felt)});
}

// A hand's path on its molecule. A path without a molecule is placed on `otherwise`.
HandOnMolecule handFrom(const fs::path& file, const std::string& otherwise) {
  auto path = openHandPath(file);
  if (!path) throw CommandError{path.problem().text()};
  HandOnMolecule hand;
  hand.molecule = otherwise.empty() ? path->label("molecule") : otherwise;
  if (hand.molecule.empty())
    throw CommandError{
        Problem{file.string(), 0, 0, tr("it does not name the molecule of this hand"), tr("name one with --molecule")}
            .text()};
  const auto molecule = openMolecule(hand.molecule);
  if (!molecule) throw CommandError{molecule.problem().text()};
  hand.scene = std::make_shared<const SphereGrid>(molecule->spheres);
  if (!path->label("balls").empty() && path->label("balls") != fingerprint(*hand.scene))
    err() << "moltact: " << file.string() << " was recorded on other spheres than " << hand.molecule << " has here\n";
  hand.path = mappedTo(*path, *hand.scene, Workspace().A_per_mm);
  return hand;
}

// The files of --recording, or else the recordings that come with the program.
std::vector<fs::path> handFiles(const BenchArguments& arguments) {
  std::vector<fs::path> out{arguments.recordings.begin(), arguments.recordings.end()};
  std::error_code error;
  if (out.empty())
    for (const auto& entry : fs::directory_iterator(assetsFolder() / "hands", error))
      if (entry.path().extension() == ".hand") out.push_back(entry.path());
  if (arguments.recordings.empty()) std::sort(out.begin(), out.end());
  return out;
}

void addHands(const BenchArguments& arguments, const std::vector<const Method*>& methods, Report& report) {
  std::vector<HandOnMolecule> hands;
  for (const fs::path& file : handFiles(arguments)) hands.push_back(handFrom(file, arguments.recording_molecule));
  const ProgressBar bar("hands");
  const auto replays =
      replayHands(hands, withNoiseFloor(methods), methods, arguments.quick ? 0.02 : 0.2, std::cref(bar));
  report.tables.push_back(handsTable(replays));
  report.tables.push_back(handsFeltTable(replays));
  report.tables.push_back(handsFigures(replays));
  report.sentences.push_back({"hands_sentences", feltSentences(feltOverAll(replays))});
}

void addBodies(const BenchArguments& arguments, Report& report) {
  BodyTradeOffOptions options;
  options.methods = chosenForBodies(arguments.methods);
  if (arguments.quick) options.ticks = 1000, options.judge_every = 10, options.runs = 2;
  const ProgressBar bar("bodies");
  const auto points = measureBodies(
      options, [](const std::string& id) { return openMolecule(id); }, std::cref(bar));
  if (!points) throw CommandError{points.problem().text()};
  report.tables.push_back(bodyTradeOffTable(*points, options));
  report.sentences.push_back({"body_trade_off_sentences", bodyTradeOffSentences(*points)});
  report.pictures.push_back({"rigid-bodies.svg", bodyTradeOffChart(*points)});
  BodyMatrixOptions matrix;
  matrix.methods = options.methods;
  matrix.seed = arguments.seed;
  matrix.draws = arguments.quick ? 2 : 10;
  const auto results = measureBodyMatrix(matrix, std::cref(bar));
  report.excerpts.push_back(bodyScenesTable());
  report.tables.push_back(bodyMatrix(results));
  report.tables.push_back(bodyMatrixFigures(results));
  report.sentences.push_back({"body_matrix_sentences", bodyMatrixSentences(results)});
}

// The page's ticks that the arguments name; empty without them. A fault ends the command before anything is measured.
std::string pageTicks(const BenchArguments& arguments) {
  if (arguments.page_ticks.empty()) return {};
  if (arguments.part != "all" && arguments.part != "energies")
    throw CommandError{"--page-ticks belongs to the chart of energies; measure 'energies' or 'all'"};
  auto lines = readFile(arguments.page_ticks, 1u << 20, "use what moltact_energy_ticks printed");
  if (!lines) throw CommandError{lines.problem().text()};
  std::vector<EnergyTradeOff> none;
  if (const auto problem = addPageTicks(*lines, none)) throw CommandError{problem->text()};
  return *std::move(lines);
}

void addEnergies(const BenchArguments& arguments, const std::string& page_ticks, Report& report) {
  EnergyTradeOffOptions options;
  if (arguments.quick) options.ticks = 200, options.runs = 2, options.judged_pairs = 1e7, options.min_spacing_A = 0.5;
  const ProgressBar bar("energies");
  auto points = measureEnergies(
      options, [](const std::string& id) { return openMolecule(id); }, std::cref(bar));
  if (!points) throw CommandError{points.problem().text()};
  if (!page_ticks.empty()) addPageTicks(page_ticks, *points);
  report.tables.push_back(energyTradeOffTable(*points, options));
  report.sentences.push_back({"energy_trade_off_sentences", energyTradeOffSentences(*points)});
  report.pictures.push_back({"energies.svg", energyTradeOffChart(*points)});
  FieldMatrixOptions matrix;
  matrix.seed = arguments.seed;
  matrix.draws = arguments.quick ? 2 : 10;
  const auto results = measureFieldMatrix(matrix, std::cref(bar));
  report.excerpts.push_back(fieldScenesTable());
  report.tables.push_back(fieldMatrix(results));
  report.sentences.push_back({"field_matrix_sentences", fieldMatrixSentences(results)});
}

// Writes the tables between their markers in every page of the folder that has the markers.
void updatePages(const fs::path& folder, const Report& report) {
  std::vector<fs::path> pages;  // listed before any is written
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".md") pages.push_back(entry.path());
  for (const fs::path& page : pages) {
    std::ifstream in(page, std::ios::binary);
    const std::string before{std::istreambuf_iterator<char>(in), {}};
    std::string after = before;
    for (const auto* tables : {&report.tables, &report.excerpts})
      for (const ReportTable& t : *tables) after = replacedBetweenMarkers(after, t.name, '\n' + toMarkdown(t) + '\n');
    for (const auto& [name, text] : report.sentences) after = replacedBetweenMarkers(after, name, '\n' + text + '\n');
    if (after != before) write(page, after);
  }
  for (const auto& [name, svg] : report.pictures) write(folder / "pictures" / name, svg);
}

}  // namespace

void runBench(const BenchArguments& arguments) {
  checkNames(arguments.methods);
  const auto methods = chosen(arguments.methods, arguments.quick);
  const std::string page_ticks = pageTicks(arguments);
  tryOutputs(arguments);
  const bool all = arguments.part == "all";
  const auto begin = std::chrono::steady_clock::now();
  Report report;
  if (all || arguments.part == "tables") addTables(arguments, methods, report);
  if (all || arguments.part == "chart") addChart(arguments, methods, report);
  if (all || arguments.part == "feel") addFeel(arguments, unlimited(methods, arguments.methods), report);
  if (all || arguments.part == "hands") addHands(arguments, unlimited(methods, arguments.methods), report);
  if (all || arguments.part == "stability") addStability(arguments, unlimited(methods, arguments.methods), report);
  if (all || arguments.part == "bodies") addBodies(arguments, report);
  if (all || arguments.part == "energies") addEnergies(arguments, page_ticks, report);

  for (const ReportTable& t : report.tables)
    if (!t.name.ends_with("_figures"))
      out() << Lines{toConsole(t)} << '\n';  // thousands of rows: only for --csv and
                                             // --json
  const std::string command = "moltact bench " + arguments.part + (arguments.quick ? " --quick" : "") + " --seed " +
                              std::to_string(arguments.seed);
  if (!arguments.json.empty()) write(arguments.json, toJson(report.tables, command));
  if (!arguments.csv.empty())
    for (const ReportTable& t : report.tables) write(fs::path(arguments.csv) / (t.name + ".csv"), toCsv(t));
  if (!arguments.svg.empty())
    for (const auto& [name, svg] : report.pictures) write(fs::path(arguments.svg) / name, svg);
  if (!arguments.markdown.empty()) {
    std::string page;
    for (const ReportTable& t : report.tables)
      page += "## " + t.title + "\n\n" + toMarkdown(t) + "\nMade by `" + command + "`.\n\n";
    write(arguments.markdown, page);
  }
  if (!arguments.docs.empty()) updatePages(arguments.docs, report);
  err() << command << ": " << readable(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count())
        << " s\n";
}

}  // namespace moltact
