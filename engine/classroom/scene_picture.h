// A small picture of a student's scene, as a student's page sends it: a JPEG, in base64. Pure; any thread but the haptic one.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace moltact {

inline constexpr std::size_t kMaxPictureBytes = std::size_t{48} << 10;  ///< of the JPEG
inline constexpr int kMaxPictureSide = 1024;                            ///< unit: pixel

/// The bytes that a text in base64 (RFC 4648, with its padding, without line ends) stands for; nothing for another text.
std::optional<std::string> fromBase64(std::string_view text);

/// Whether the bytes have the form of a JPEG of at most kMaxPictureBytes and kMaxPictureSide, by its markers up to the
/// frame's header. A browser that shows it then needs at most 4 MB.
bool isSmallJpeg(std::string_view bytes);

}  // namespace moltact
