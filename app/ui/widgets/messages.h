// Short messages over the view. Notices and warnings disappear after a reading time. Errors, and messages that need an
// answer, stay until the user dismisses them or they no longer apply. Window's thread.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace moltact {

enum class MessageKind { Notice, Warning, Error };

/// Identifies a message; 0 is no message.
using MessageId = unsigned;

struct Message {
  MessageKind kind = MessageKind::Notice;
  std::string text;
  double left_s = -1.0;                        ///< remaining time until it disappears; negative: stays until dismissed
  std::vector<std::string_view> actions = {};  ///< names of the actions (actions.h) that it offers
  MessageId id = 0;
};

class Messages {
 public:
  static constexpr std::size_t kMax = 4;                       ///< beyond this number, the oldest is removed
  static constexpr double kNotice_s = 6.0, kWarning_s = 14.0;  ///< the shortest display times
  static constexpr double kRead_bytes_per_s = 14.0;  ///< reading speed that sets the display time of a long text

  void notice(std::string text) { addForAWhile(MessageKind::Notice, std::move(text), kNotice_s); }
  void warning(std::string text) { addForAWhile(MessageKind::Warning, std::move(text), kWarning_s); }
  /// Adds a message that stays until it is dismissed or taken back, with buttons for the actions.
  MessageId ask(MessageKind kind, std::string text, std::vector<std::string_view> actions) {
    add({kind, std::move(text), -1.0, std::move(actions)});
    return all_.back().id;
  }
  /// Removes a message that no longer applies and sets `id` to 0.
  void takeBack(MessageId& id) {
    std::erase_if(all_, [&](const Message& m) { return id != 0 && m.id == id; });
    id = 0;
  }
  /// Whether the message is still shown: neither dismissed nor displaced by newer ones.
  bool shows(MessageId id) const {
    return std::any_of(all_.begin(), all_.end(), [&](const Message& m) { return id != 0 && m.id == id; });
  }
  void error(std::string text) { add({MessageKind::Error, std::move(text)}); }

  const std::vector<Message>& all() const { return all_; }
  void dismiss(std::size_t index) { all_.erase(all_.begin() + std::ptrdiff_t(index)); }
  void clearErrors() {
    std::erase_if(all_, [](const Message& m) { return m.kind == MessageKind::Error; });
  }
  /// Advances the time by `dt_s` and removes the messages whose time has passed.
  void age(double dt_s) {
    for (Message& m : all_)
      if (m.left_s >= 0) m.left_s = std::max(0.0, m.left_s - dt_s);
    std::erase_if(all_, [](const Message& m) { return m.left_s == 0.0; });
  }
  /// True if a message is shown that will disappear by itself.
  bool anyTimed() const {
    return std::any_of(all_.begin(), all_.end(), [](const Message& m) { return m.left_s >= 0; });
  }

 private:
  void addForAWhile(MessageKind kind, std::string text, double min_s) {
    const double shown_s = std::max(min_s, double(text.size()) / kRead_bytes_per_s);
    add({kind, std::move(text), shown_s});
  }
  void add(Message message) {
    std::erase_if(all_, [&](const Message& m) { return m.text == message.text; });
    message.id = ++given_;
    all_.push_back(std::move(message));
    if (all_.size() > kMax) all_.erase(all_.begin());
  }
  std::vector<Message> all_;
  MessageId given_ = 0;
};

}  // namespace moltact
