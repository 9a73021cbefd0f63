#include "app/ui/extensions/state_text.h"

#include "app/ui/application/panel_state.h"
#include "app/ui/extensions/reveal_policy.h"
#include "app/ui/lesson/lesson_guide.h"
#include "app/ui/scene/contact_text.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/glossary.h"
#include "engine/platform/terminal.h"

namespace moltact {
namespace {

// Describes the contact, or why there is none, without the force, which fluctuates.
std::string whatOf(const Molecule* molecule, const ServoSample& now) {
  if (molecule && now.contact.touching()) return touchedText(*molecule, now.contact, now.holds_body);
  return now.felt() ? unnamedContactText(now.contact, true)
                    : contactText(molecule, now.contact, 0.0, true, now.holds_body);
}

}  // namespace

std::optional<Problem> StateText::writeTo(const std::filesystem::path& file) {
  to_terminal_ = file == "-";
  if (to_terminal_) return std::nullopt;
  std::error_code error;
  // Appends instead of replacing the file by a rename, because a reader has it open.
  const bool there = std::filesystem::exists(file, error);
  Expected<AppendFile> opened = AppendFile::open(file, there ? AppendFile::Begin::Continue : AppendFile::Begin::New);
  if (!opened) return opened.problem();
  if (std::filesystem::is_regular_file(file, error))
    if (const auto problem = opened->cut(0)) return problem;
  file_.emplace(*std::move(opened));
  return std::nullopt;
}

// Every line is flushed at once for the reader.
void StateText::write(const std::string& line) {
  if (to_terminal_) {
    out() << line << '\n';
    out().flush();
  }
  if (file_) file_->append(oneLine(line) + '\n');  // a full disk loses a line but does not stop the window
}

void StateText::stepChanged() {
  const LessonSession* session = lesson_.session();
  write(session->step().aside ? trf("aside: {0}", session->step().title)
                              : trf("step {0} of {1}: {2}", session->numberOf(session->mainStepIndex()),
                                    session->route().size(), session->step().title));
}

std::string StateText::line(const HapticSession& scene) const {
  if (!tells_contact_ || tells_unnamed_) return reading_.text();
  return touchingText(reading_.text(), scene.log().shownForce_N(), scene.servo_settings.force_on);
}

void StateText::afterPanels() {
  const LessonSession* session = lesson_.session();
  if (const std::size_t at = session ? session->currentTask() : 0; session && at < session->step().tasks.size()) {
    const std::string sentence = session->task(at).sentence;
    if (!sentence.empty() && task_.update(sentence, sentence, 0, time_.now_s)) write(sentence);
  }
  if (const LessonPanelMemory::Word& open = panels_.lesson_memory.word; open.id != word_) {
    word_ = open.id;
    if (const GlossaryWord* word = session ? findWord(session->lesson(), word_) : nullptr)
      write(trf("{0}: {1}", word->word, plainText(word->meaning)));
  }
  const Molecule* molecule = scene_.stage().molecule.get();
  const ServoSample& now = scene_.log().latest();
  const Contact& contact = now.contact;
  const bool force_on = scene_.servo_settings.force_on;
  const double force_N = force_on ? scene_.log().force_N() : 0.0;
  const bool unnamed = !policy_.names(contact);
  const std::string what = unnamed ? policy_.unnamedText(true) : whatOf(molecule, now);
  const std::string whole = unnamed ? policy_.unnamedText(false) : feltText(molecule, now, force_N, force_on);
  if (reading_.update(what, what, 0, time_.now_s)) {
    tells_contact_ = molecule && contact.touching();
    tells_unnamed_ = unnamed;
  }
  if (reading_.text() == what) named_atoms_ = contact.atoms;
  if (speaking_.update(what, whole, force_N, time_.now_s)) write(whole);
  owing_ = reading_.hasUnreported(what) || ((to_terminal_ || file_) && speaking_.hasUnreported(what));
}

}  // namespace moltact
