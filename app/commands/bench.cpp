// moltact bench: speed, accuracy, feel and stability of every method.
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>

#include "app/commands/command.h"
#include "engine/bench/charts.h"
#include "engine/bench/cool_ticks.h"
#include "engine/bench/feel.h"
#include "engine/bench/hip_paths.h"
#include "engine/bench/report_table.h"
#include "engine/bench/stability.h"
#include "engine/bench/tables.h"
#include "engine/bench/trade_off.h"
#include "engine/bench/trade_off_sentences.h"
#include "engine/molecule/catalogue.h"
#include "engine/platform/terminal.h"

namespace moltact {
namespace {

using namespace bench;
namespace fs = std::filesystem;

constexpr std::size_t kChartSpheres = 13'751;  // as many as the paper's largest structure

struct BenchArguments {
  std::string part = "all", json, csv, svg, docs, markdown;
  std::vector<std::string> methods;
  bool quick = false;
  std::uint64_t seed = 1;
};

// What was measured, in the order it is shown.
struct Report {
  std::vector<ReportTable> tables;
  std::vector<ReportTable> excerpts;                          // parts of long tables, for the pages alone
  std::vector<std::pair<std::string, std::string>> pictures;  // file name, SVG
  std::vector<std::pair<std::string, std::string>> sentences;  // marker's name, Markdown: what the tables say
};

class ProgressBar {
 public:
  explicit ProgressBar(std::string part) : part_(std::move(part)), shown_(standardErrorIsTerminal()) {}
  ~ProgressBar() {
    if (shown_) std::cerr << "\r\033[K" << std::flush;
  }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void operator()(double share, std::string_view what) const {
    if (!shown_) return;
    constexpr int kWidth = 30;
    const int full = static_cast<int>(share * kWidth);
    std::cerr << "\r\033[K" << part_ << " [" << std::string(std::size_t(full), '#')
              << std::string(std::size_t(kWidth - full), '.') << "] " << static_cast<int>(100 * share)
              << " %  " << what << std::flush;
  }

 private:
  std::string part_;
  bool shown_;
};

[[noreturn]] void cannotWrite(const fs::path& file) {
  throw CommandError{Problem{file.string(), 0, 0, "the file cannot be written",
                             "check the folder, its permissions and the space left"}
                         .text()};
}

void write(const fs::path& file, const std::string& text) {
  std::error_code error;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.flush();
  if (!out) cannotWrite(file);
}

// Fails where write() would fail for want of a folder or a right; what is there stays as it is.
void tryWriting(const fs::path& file) {
  std::error_code error;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
  const bool was_there = fs::exists(file, error);
  if (!std::ofstream(file, std::ios::binary | std::ios::app)) cannotWrite(file);
  if (!was_there) fs::remove(file, error);
}

void checkPages(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw CommandError{Problem{folder.string(), 0, 0, "there is no such folder",
                               "name the folder of the pages, such as docs"}
                           .text()};
}

std::vector<const Method*> chosen(const std::vector<std::string>& names, bool quick) {
  // Of the methods that prepare a whole scene the finer take seconds for it: only in full runs, or by name.
  constexpr std::string_view kNotQuick[] = {"grid02-ready", "sasmesh025"};
  std::vector<const Method*> out;
  for (const Method& m : benchMethods())
    if ((names.empty() && !(quick && std::ranges::find(kNotQuick, m.name) != std::end(kNotQuick))) || m.name == "exact" || std::find(names.begin(), names.end(), m.name) != names.end())
      out.push_back(&m);
  for (const std::string& name : names)
    if (!findBenchMethod(name)) {
      std::string known;
      for (const Method& m : benchMethods()) known.append(known.empty() ? "" : ", ").append(m.name);
      throw CommandError{
          Problem{"--methods", 0, 0, "there is no method \"" + name + "\"", "choose from " + known}.text()};
    }
  return out;
}

// Stability makes thousands of trackers and changes the probe under the finger: for the methods that a person is offered.
std::vector<const Method*> offeredOf(std::vector<const Method*> methods) {
  std::erase_if(methods, [](const Method* m) { return !findMethod(m->name); });
  return methods;
}

// Structures that the library holds or the user has fetched; those that are not there are passed over.
std::vector<TableScene> structures() {
  std::vector<TableScene> out;
  const MoleculeFolders folders = MoleculeFolders::ofThisComputer();
  const auto add = [&](const std::string& id, const std::string& paper) {
    if (!findMolecule(id, folders)) return;
    const auto molecule = openMolecule(id);
    if (!molecule) return;
    out.push_back(
        {molecule->id, molecule->atoms.size(), [balls = molecule->balls()] { return balls; }, paper});
  };
  add("1ubq", "");
  add("2hhb", "");
  for (const char* id : {"5ADH", "8TIM", "1KBW"}) add(id, id);
  return out;
}

// Told before anything is measured: a quarter of an hour is too long to learn that a folder cannot be written.
void checkOutputs(const BenchArguments& arguments) {
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

// On the spheres of the chart, beside the same methods' ticks in a row.
void addCool(const BenchArguments& arguments, const std::vector<const Method*>& methods,
             const std::vector<SceneTimes>& times, Report& report) {
  const auto scene = std::make_shared<const BallScene>(proteinLike(kChartSpheres, static_cast<unsigned>(arguments.seed)));
  StrokePlan strokes = plan(arguments);
  strokes.strokes = 4;
  const CoolPlan ticks = arguments.quick ? CoolPlan{100, 24} : CoolPlan{1000, 200};
  const ProgressBar bar("caches");
  const auto cool = timeCool(thatBear(methods, kChartSpheres), scene, kWaterProbe_A,
                             contactStrokes(scene, kWaterProbe_A, strokes), ticks, std::cref(bar));
  const auto hot = std::find_if(times.begin(), times.end(), [&](const SceneTimes& s) { return s.spheres == kChartSpheres; });
  report.tables.push_back(coolTable(cool, hot == times.end() ? std::vector<TickTimes>{} : hot->contact, kChartSpheres));
  report.sentences.push_back({"cool_sentences", coolSentences(cool)});
}

void addTables(const BenchArguments& arguments, const std::vector<const Method*>& methods, Report& report) {
  std::vector<TableScene> scenes = madeScenes(arguments.quick, arguments.seed);
  for (TableScene& one : structures()) scenes.push_back(std::move(one));
  TableOptions options{methods, kWaterProbe_A, plan(arguments), arguments.quick ? 0.1 : 1.0,
                       arguments.quick ? std::size_t(kChartSpheres) : 0};
  const ProgressBar bar("tables");
  const auto times = measureTables(scenes, options, std::cref(bar));
  report.tables.push_back(besidePaperTable(times));
  report.tables.push_back(tickTable(times));
  report.tables.push_back(readyTable(times));
  for (const auto& [name, table] :
       {std::pair{"ticks", tickTable(times)}, std::pair{"ready", readyTable(times)}}) {
    report.excerpts.push_back(
        rowsWhere(table, "scene", "13 800 protein-like", std::string(name) + "_13800", table.title));
    report.excerpts.push_back(rowsWhere(table, "method", "exact", std::string(name) + "_exact", table.title));
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

void addStability(const BenchArguments& arguments, const std::vector<const Method*>& methods,
                  Report& report) {
  StabilityOptions options;
  options.methods = methods;
  options.seed = arguments.seed;
  options.stiffness = true;
  const ProgressBar bar("stability");
  const auto results = measureStability(options, std::cref(bar));
  report.tables.push_back(stabilityMatrix(results));
  report.tables.push_back(stiffnessTable(results, stiffestStableOnWall(options.loop)));
  report.tables.push_back(stabilityFigures(results));
}

// Writes the tables between their markers in every page of the folder that has such markers.
void updatePages(const fs::path& folder, const Report& report) {
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".md") continue;
    std::ifstream in(entry.path(), std::ios::binary);
    const std::string before{std::istreambuf_iterator<char>(in), {}};
    std::string after = before;
    for (const auto* tables : {&report.tables, &report.excerpts})
      for (const ReportTable& t : *tables)
        after = replacedBetweenMarkers(after, t.name, '\n' + toMarkdown(t) + '\n');
    for (const auto& [name, text] : report.sentences)
      after = replacedBetweenMarkers(after, name, '\n' + text + '\n');
    if (after != before) write(entry.path(), after);
  }
  for (const auto& [name, svg] : report.pictures) write(folder / "pictures" / name, svg);
}

void run(const BenchArguments& arguments) {
  const auto methods = chosen(arguments.methods, arguments.quick);
  checkOutputs(arguments);
  const bool all = arguments.part == "all";
  const auto begin = std::chrono::steady_clock::now();
  Report report;
  if (all || arguments.part == "tables") addTables(arguments, methods, report);
  if (all || arguments.part == "chart") addChart(arguments, methods, report);
  if (all || arguments.part == "feel") report.tables.push_back(feelTable(measureFeel(methods)));
  if (all || arguments.part == "stability") addStability(arguments, offeredOf(methods), report);

  for (const ReportTable& t : report.tables)
    if (t.name != "stability_figures" || !all) std::cout << toConsole(t) << '\n';
  const std::string command = "moltact bench " + arguments.part + (arguments.quick ? " --quick" : "") +
                              " --seed " + std::to_string(arguments.seed);
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
  std::cerr << command << ": "
            << readable(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count())
            << " s\n";
}

}  // namespace

void addBench(CLI::App& app) {
  auto arguments = std::make_shared<BenchArguments>();
  CLI::App* command =
      app.add_subcommand("bench", "Measure speed, accuracy, feel and stability of every method");
  command->add_option("part", arguments->part, "tables, chart, feel, stability or all")
      ->capture_default_str()
      ->check(CLI::IsMember({"tables", "chart", "feel", "stability", "all"}));
  command->add_flag("--quick", arguments->quick,
                    "A minute instead of a quarter of an hour; the figures are rougher");
  command
      ->add_option("--methods", arguments->methods, "Only these, with commas between (exact is always there)")
      ->delimiter(',');
  command->add_option("--seed", arguments->seed, "Of the scenes and motions")->capture_default_str();
  command->add_option("--json", arguments->json, "Write all tables to this file");
  command->add_option("--csv", arguments->csv, "Write each table to a file in this folder");
  command->add_option("--svg", arguments->svg, "Write the charts to this folder");
  command->add_option("--markdown", arguments->markdown, "Write all tables to this page");
  command->add_option("--docs", arguments->docs, "Renew the tables and charts of the pages in this folder");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace moltact
