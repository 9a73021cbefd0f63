// The text of a C++ source in parts: code, comments, tokens, and types with their members.
#pragma once

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace moltact::test {

inline bool isWordPart(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

// A source in two halves of the same length and lines: each holds blanks where the other has text. Literals are in
// neither.
struct Halves {
  std::string code, comments;
};

inline Halves halvesOf(const std::string& source) {
  Halves out{std::string(source.size(), ' '), std::string(source.size(), ' ')};
  for (std::size_t k = 0; k < source.size(); ++k)
    if (source[k] == '\n') out.code[k] = out.comments[k] = '\n';
  const auto copy = [&](std::string& to, std::size_t from, std::size_t end) {
    for (std::size_t k = from; k < std::min(end, source.size()); ++k) to[k] = source[k];
  };
  for (std::size_t at = 0; at < source.size();) {
    const std::string_view rest = std::string_view(source).substr(at);
    std::size_t end = at + 1;
    if (rest.starts_with("//")) {
      end = std::min(source.find('\n', at), source.size());
      copy(out.comments, at + 2, end);
    } else if (rest.starts_with("/*")) {
      end = std::min(source.find("*/", at + 2), source.size());
      copy(out.comments, at + 2, end);
      end += 2;
    } else if (rest.starts_with("R\"") && (at == 0 || !isWordPart(source[at - 1]))) {
      const std::size_t open = source.find('(', at);
      const std::string close = ")" + source.substr(at + 2, open - at - 2) + "\"";
      end = std::min(source.find(close, open), source.size()) + close.size();
    } else if (rest[0] == '"' || (rest[0] == '\'' && (at == 0 || !isWordPart(source[at - 1])))) {
      while (end < source.size() && source[end] != rest[0]) end += source[end] == '\\' ? 2 : 1;
      ++end;
    } else {
      copy(out.code, at, end);
    }
    at = end;
  }
  return out;
}

// Words, "::" and single signs.
inline std::vector<std::string> tokensOf(const std::string& code) {
  std::vector<std::string> out;
  for (std::size_t at = 0; at < code.size();) {
    if (std::isspace(static_cast<unsigned char>(code[at]))) {
      ++at;
      continue;
    }
    std::size_t end = at + 1;
    if (isWordPart(code[at]))
      while (end < code.size() && isWordPart(code[end])) ++end;
    else if (code.compare(at, 2, "::") == 0)
      ++end;
    out.push_back(code.substr(at, end - at));
    at = end;
  }
  return out;
}

inline bool isWord(const std::string& token) {
  return isWordPart(token[0]) && !std::isdigit(static_cast<unsigned char>(token[0]));
}

// The types and namespaces of the sources, each with the words in its braces: its members, and more.
struct Scopes {
  std::map<std::string, std::set<std::string>> words, bases;

  void read(const std::string& code) {
    const std::vector<std::string> tokens = tokensOf(code);
    std::vector<std::string> open;  // the scopes round a token; empty: braces of something else
    for (std::size_t k = 0; k < tokens.size(); ++k) {
      const std::string& token = tokens[k];
      if (token == "{") {
        open.emplace_back();
      } else if (token == "}") {
        if (!open.empty()) open.pop_back();
      } else if (token == "class" || token == "struct" || token == "union" || token == "enum" || token == "namespace") {
        if (const std::size_t brace = readHead(tokens, k + 1); brace > 0) {
          for (std::size_t j = k + 1; j < brace; ++j) {
            add(open, tokens[j]);
            if (tokens[j] == "::") words[tokens[j - 1]].insert(tokens[j + 1]);
          }
          open.push_back(head_);
          k = brace;
        }
      } else if (token == "::" && k > 0 && k + 1 < tokens.size() && isWord(tokens[k - 1])) {
        words[tokens[k - 1]].insert(tokens[k + 1]);
      } else {
        add(open, token);
      }
    }
  }

  bool knows(const std::string& scope) const { return words.contains(scope); }

  bool has(const std::string& scope, const std::string& member) const {
    std::set<std::string> seen;
    std::vector<std::string> next{scope};
    while (!next.empty()) {
      const std::string now = next.back();
      next.pop_back();
      if (!seen.insert(now).second) continue;
      if (const auto found = words.find(now); found != words.end() && found->second.contains(member)) return true;
      if (const auto found = bases.find(now); found != bases.end())
        next.insert(next.end(), found->second.begin(), found->second.end());
    }
    return false;
  }

 private:
  void add(const std::vector<std::string>& open, const std::string& token) {
    if (!isWord(token)) return;
    for (const std::string& scope : open)
      if (!scope.empty()) words[scope].insert(token);
  }

  // The head of a type from its name on: where its brace is, and 0 where it has none.
  std::size_t readHead(const std::vector<std::string>& tokens, std::size_t from) {
    head_.clear();
    bool after_colon = false;
    for (std::size_t k = from; k < tokens.size(); ++k) {
      const std::string& token = tokens[k];
      if (token == "{") {
        words[head_];
        return k;
      }
      if (token == ";" || token == "(" || token == ")" || token == "=" || token == "}") return 0;
      if (!after_colon && (token == ">" || token == "," || token == "*" || token == "&")) return 0;
      if (token == ":")
        after_colon = true;
      else if (!isWord(token) || token == "final" || token == "class" || token == "struct")
        continue;
      else if (after_colon)
        bases[head_].insert(token);
      else
        head_ = token;
    }
    return 0;
  }

  std::string head_;
};

}  // namespace moltact::test
