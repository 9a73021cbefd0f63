// The frames of a GRO file and the models of a PDB or mmCIF file: positions only. engine/molecule reads the atoms'
// descriptions.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "engine/core/text.h"
#include "engine/language/catalogue.h"
#include "engine/molecule/parsed_structure.h"
#include "engine/trajectory/frame_formats.h"

namespace moltact {
namespace {

std::string_view columns(std::string_view line, std::size_t from, std::size_t count) {
  return from < line.size() ? line.substr(from, count) : std::string_view();
}

bool wholeNumber(std::string_view text, std::int64_t& value) {
  text = trimmed(text);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size();
}

/// Frames of lines of text.
class LineFrames : public FoundFrames {
 public:
  explicit LineFrames(RandomAccessFile file) : FoundFrames(std::move(file)), lines_(file_) {}
  std::optional<Problem> open() { return findFirst(); }

 protected:
  /// A Problem if this frame has another number of atoms than the first one.
  std::optional<Problem> sameAtoms(std::size_t atoms) {
    if (atoms_ == 0) atoms_ = atoms;
    if (atoms == atoms_) return std::nullopt;
    return frameProblem(file_.name(), frames_, trf("it has {0} atoms and not {1}", atoms, atoms_));
  }
  Expected<TrajectoryFrame> checked(std::size_t frame, TrajectoryFrame out) {
    if (out.positions_A.size() != atoms_) return damaged(frame);
    if (auto problem = checkPositions(file_.name(), frame, out.positions_A)) return *problem;
    return out;
  }
  Problem damaged(std::size_t frame) const { return frameProblem(file_.name(), frame, tr("it is damaged")); }
  std::uint64_t endOfFrame(std::size_t frame) const {
    return frame + 1 < begins_.size() ? begins_[frame + 1] : searched_;
  }

  LinesFrom lines_;
};

class GroFrames final : public LineFrames {
 public:
  using LineFrames::LineFrames;
  std::string_view format() const override { return "GRO"; }

 protected:
  Expected<std::optional<Ending>> endOf(std::uint64_t at) override {
    lines_.seek(at);
    std::string_view line;
    if (!lines_.next(line)) return std::optional<Ending>();
    const bool blank = trimmed(line).empty();
    if (!lines_.next(line)) {
      if (blank) return std::optional<Ending>();
      return frameCutShort(file_.name(), frames_);
    }
    std::int64_t atoms = 0;
    if (blank && trimmed(line).empty()) return std::optional<Ending>();
    if (!wholeNumber(line, atoms) || atoms < 1 || std::size_t(atoms) > kMaxMoleculeAtoms)
      return frames_ ? damaged(frames_) : notOfFormat(file_.name(), format());
    if (auto problem = sameAtoms(std::size_t(atoms))) return *problem;
    for (std::int64_t k = 0; k <= atoms; ++k)
      if (!lines_.next(line)) return frameCutShort(file_.name(), frames_);
    return std::optional<Ending>(Ending{lines_.at()});
  }

 public:
  Expected<TrajectoryFrame> read(std::size_t frame) override {
    constexpr std::size_t kFirstColumn = 20;
    lines_.seek(begins_[frame]);
    TrajectoryFrame out;
    std::string_view line;
    lines_.next(line);
    if (const std::size_t t = line.rfind("t="); t != std::string_view::npos) {
      double time = 0.0;
      const std::string_view word = trimmed(line.substr(t + 2));
      if (parseNumber(word.substr(0, word.find(' ')), time)) out.time_ps = time;
    }
    lines_.next(line);
    out.positions_A.resize(atoms_);
    for (Vec3& place : out.positions_A) {
      if (!lines_.next(line)) return damaged(frame);
      // The width of a coordinate is the distance of the decimal points.
      const std::size_t first = line.find('.', kFirstColumn),
                        second = first == std::string_view::npos ? first : line.find('.', first + 1);
      if (second == std::string_view::npos) return damaged(frame);
      for (int k = 0; k < 3; ++k) {
        const std::size_t width = second - first;
        if (!parseNumber(columns(line, kFirstColumn + std::size_t(k) * width, width), place[k])) return damaged(frame);
      }
      place *= kAngstrom_per_nanometre;
    }
    if (lines_.next(line)) {
      double v[9] = {};
      int count = 0;
      for (const LineWord& word : wordsOfLine(line))
        if (count < 9 && parseNumber(word.text, v[count])) ++count;
      glm::dmat3 cell(0.0);
      cell[0] = {v[0], v[3], v[4]};
      cell[1] = {v[5], v[1], v[6]};
      cell[2] = {v[7], v[8], v[2]};
      if (count >= 3) out.cell_A = cellOf(cell * kAngstrom_per_nanometre);
    }
    return checked(frame, std::move(out));
  }
};

class PdbModels final : public LineFrames {
 public:
  using LineFrames::LineFrames;
  std::string_view format() const override { return "PDB"; }

 protected:
  static bool isAtom(std::string_view line) { return line.starts_with("ATOM  ") || line.starts_with("HETATM"); }

  Expected<std::optional<Ending>> endOf(std::uint64_t at) override {
    lines_.seek(at);
    std::size_t atoms = 0;
    std::uint64_t end = at;
    for (std::string_view line;;) {
      const std::uint64_t before = lines_.at();
      if (!lines_.next(line)) {
        end = before;
        break;
      }
      if (isAtom(line)) {
        ++atoms;
        continue;
      }
      if (atoms == 0) continue;
      end = lines_.at();
      if (line.starts_with("ENDMDL") || trimmed(line) == "END") break;
      if (line.starts_with("MODEL ")) {
        end = before;
        break;
      }
    }
    if (atoms == 0) return std::optional<Ending>();
    if (auto problem = sameAtoms(atoms)) return *problem;
    return std::optional<Ending>(Ending{end});
  }

 public:
  Expected<TrajectoryFrame> read(std::size_t frame) override {
    constexpr double kMinCell_A = 2.0;  // structures without a cell have one of 1 A
    lines_.seek(begins_[frame]);
    TrajectoryFrame out;
    out.positions_A.reserve(atoms_);
    for (std::string_view line; lines_.at() < endOfFrame(frame) && lines_.next(line);) {
      if (isAtom(line)) {
        Vec3 place(0.0);
        for (int k = 0; k < 3; ++k)
          if (!parseNumber(columns(line, 30 + 8 * std::size_t(k), 8), place[k])) return damaged(frame);
        if (out.positions_A.size() == atoms_) return damaged(frame);
        out.positions_A.push_back(place);
      } else if (line.starts_with("CRYST1")) {
        Vec3 edges(0.0), angles(0.0);
        bool sound = true;
        for (int k = 0; k < 3; ++k)
          sound = parseNumber(columns(line, 6 + 9 * std::size_t(k), 9), edges[k]) &&
                  parseNumber(columns(line, 33 + 7 * std::size_t(k), 7), angles[k]) && sound;
        if (sound && edges[0] > kMinCell_A) out.cell_A = cellOf(edges, angles);
      }
    }
    return checked(frame, std::move(out));
  }
};

/// The words of a row of a CIF table on one line.
std::vector<std::string_view> rowWords(std::string_view line) {
  std::vector<std::string_view> out;
  for (std::size_t at = 0; at < line.size();) {
    if (line[at] == ' ' || line[at] == '\t') {
      ++at;
      continue;
    }
    std::size_t end = 0;
    if (const char quote = line[at]; quote == '\'' || quote == '"') {
      // A quote within a word ends nothing.
      end = at + 1;
      while (end < line.size() && !(line[end] == quote && (end + 1 == line.size() || line[end + 1] == ' '))) ++end;
      out.push_back(line.substr(at + 1, end - at - 1));
      ++end;
    } else {
      end = std::min(line.find_first_of(" \t", at), line.size());
      out.push_back(line.substr(at, end - at));
    }
    at = end;
  }
  return out;
}

class MmcifModels final : public LineFrames {
 public:
  using LineFrames::LineFrames;
  std::string_view format() const override { return "mmCIF"; }

 protected:
  enum Column { kX, kY, kZ, kModel, kColumns };
  static constexpr std::size_t kMissing = ~std::size_t{0};

  // The beginning of the rows of the table of atoms; the columns are stored.
  std::optional<std::uint64_t> rows() {
    constexpr std::string_view kTable = "_atom_site.";
    constexpr std::array<std::string_view, kColumns> kTags{"Cartn_x", "Cartn_y", "Cartn_z", "pdbx_PDB_model_num"};
    lines_.seek(0);
    count_ = 0;
    column_.fill(kMissing);
    for (std::string_view line;;) {
      const std::uint64_t at = lines_.at();
      if (!lines_.next(line)) return std::nullopt;
      line = trimmed(line);
      if (line.starts_with(kTable)) {
        const auto tag = std::find(kTags.begin(), kTags.end(), line.substr(kTable.size()));
        if (tag != kTags.end()) column_[std::size_t(tag - kTags.begin())] = count_;
        ++count_;
      } else if (count_ > 0) {
        if (column_[kX] == kMissing || column_[kY] == kMissing || column_[kZ] == kMissing) return std::nullopt;
        return at;
      }
    }
  }
  // Splits a line of the table; empty at its end.
  std::vector<std::string_view> row(std::string_view line) const {
    const std::string_view text = trimmed(line);
    if (text.empty() || text[0] == '#' || text[0] == '_' || text.starts_with("loop_") || text.starts_with("data_"))
      return {};
    return rowWords(text);
  }

  Expected<std::optional<Ending>> endOf(std::uint64_t at) override {
    if (at == 0) {
      const auto first = rows();
      if (!first) return notOfFormat(file_.name(), format());
      // What precedes the table is no frame.
      return std::optional<Ending>(Ending{*first, true});
    }
    lines_.seek(at);
    std::size_t atoms = 0;
    std::string model;
    std::uint64_t end = at;
    for (std::string_view line; lines_.next(line); end = lines_.at()) {
      const auto words = row(line);
      if (words.empty()) break;
      if (words.size() != count_)
        return frameProblem(file_.name(), frames_, tr("each atom must be a row on a line of its own"));
      const std::string_view name = column_[kModel] == kMissing ? std::string_view() : words[column_[kModel]];
      if (atoms > 0 && name != model) break;
      model = name;
      ++atoms;
    }
    if (atoms == 0) return std::optional<Ending>();
    if (auto problem = sameAtoms(atoms)) return *problem;
    return std::optional<Ending>(Ending{end});
  }

 public:
  Expected<TrajectoryFrame> read(std::size_t frame) override {
    lines_.seek(begins_[frame]);
    TrajectoryFrame out;
    out.positions_A.resize(atoms_);
    for (Vec3& place : out.positions_A) {
      std::string_view line;
      if (!lines_.next(line)) return damaged(frame);
      const auto words = row(line);
      if (words.size() != count_) return damaged(frame);
      for (std::size_t k = 0; k < 3; ++k)
        if (!parseNumber(words[column_[k]], place[int(k)])) return damaged(frame);
    }
    return checked(frame, std::move(out));
  }

 private:
  std::size_t count_ = 0;  // of the table's columns
  std::array<std::size_t, kColumns> column_{};
};

template <class Frames>
OpenedTrajectory openedAs(RandomAccessFile file) {
  auto out = std::make_unique<Frames>(std::move(file));
  if (auto problem = out->open()) return *problem;
  return std::unique_ptr<TrajectoryFile>(std::move(out));
}

}  // namespace

OpenedTrajectory openGroFrames(RandomAccessFile file) { return openedAs<GroFrames>(std::move(file)); }
OpenedTrajectory openPdbModels(RandomAccessFile file) { return openedAs<PdbModels>(std::move(file)); }
OpenedTrajectory openMmcifModels(RandomAccessFile file) { return openedAs<MmcifModels>(std::move(file)); }

}  // namespace moltact
