#include "engine/lesson/new_lesson.h"

#include <algorithm>

#include "engine/lesson/reader.h"
#include "engine/lesson/source_text.h"

namespace moltact {
namespace {

constexpr std::string_view kRest = R"(level: beginner
goals:
  - Touch a molecule and feel where its atoms are
  - (write here what a student can do or tell afterwards, one line each)
molecules:
  - water
author: (your name)
licence: CC-BY-4.0
# A line that starts with # in here is a note to yourself.
---

<!-- A comment like this one is never shown. Everything above the first "##" is the introduction. -->

Here you touch a single molecule of water. (Write in one or two sentences what the lesson is about.)

## The molecule

<!-- Each "##" begins a step: one page of the lesson. A step begins with what is on the stage. -->

```scene
molecule: water
probe: 1.0 Å
```

One oxygen atom, drawn in red, holds two hydrogen atoms.

```touch
reach: element O
called: the oxygen atom
say: Touch the oxygen atom.
praise: That is it. Write here what the student is to notice now.
```

> [!TIP]
> A hint stays closed until the student opens it. Tell here how to find the place: turn the molecule with the right button.

> [!NOTE]
> Teacher: A note that starts with "Teacher:" is for you and your colleagues; students do not see it.

## The crease

<!-- A step without a scene of its own keeps the one before. -->

Where two atoms meet there is a **crease**, in which the probe rests on both.

```touch
feel: crease
say: Slide over the surface until the probe settles in a crease.
praise: You feel two atoms at the same time.
```

### Question: How many atoms hold the probe in a crease?

- [ ] One → That is what you feel on a round face. [Look closer](#aside-a-closer-look) and try again.
- [x] Two → Yes. Each pushes it away from its own centre.

## Aside: A closer look

<!-- Students come to an aside only by a link, and from it back to where they were. -->

In the crease the probe touches both atoms at once, so it can move only along the line between them.
)";

bool counts(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || (c & 0x80); }

/// Without the extension ".md" and blanks at both ends.
std::string_view bare(std::string_view name) {
  name = stripped(name);
  if (name.ends_with(".md")) name.remove_suffix(3);
  return stripped(name);
}

}  // namespace

std::string lessonTitle(std::string_view name) {
  std::string out(bare(name));
  // Converts a file name to words.
  if (out.find(' ') == std::string::npos)
    std::replace_if(
        out.begin(), out.end(), [](char c) { return c == '-' || c == '_'; }, ' ');
  if (!out.empty() && out[0] >= 'a' && out[0] <= 'z') out[0] = static_cast<char>(out[0] - 'a' + 'A');
  return out;
}

std::string lessonFileName(std::string_view name) {
  const std::string stem = slug(bare(name));
  return std::any_of(stem.begin(), stem.end(), counts) ? stem + ".md" : std::string();
}

std::string newLessonText(std::string_view title) {
  return "---\ntitle: " + std::string(title) + '\n' + std::string(kRest);
}

}  // namespace moltact
