// One frame without a window: to files for a person, to one file for the grader.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "app/session.h"
#include "gl/context.h"

namespace penumbra {

// One .exr and .png per named image and frame.json, all of them or none.
void renderToFolder(Session& session, const Context& context, glm::ivec2 size,
                    const std::optional<std::set<std::string>>& wanted,
                    const std::filesystem::path& out);

// The wanted images in one core/frame_file.h file.
void renderToFrameFile(Session& session, const Context& context, glm::ivec2 size,
                       const std::optional<std::set<std::string>>& wanted,
                       const std::filesystem::path& file);

// What a reader of the frame must know: the truth that the technique is held to, GL strings, how
// passes were timed.
std::map<std::string, std::string> infoStrings(Session& session, const Context& context);

}  // namespace penumbra
