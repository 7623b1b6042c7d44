// Text tables.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace autoref::runner {

enum class Align { kLeft, kRight };

// Width of a UTF-8 text in characters.
std::size_t width_of(const std::string& text);

// Formats one line per row. All rows must have as many cells as the first. A column is as wide as
// its widest cell; cells are right-aligned unless `columns` says otherwise.
std::string aligned(const std::vector<std::vector<std::string>>& rows,
                    const std::vector<Align>& columns = {});

}  // namespace autoref::runner
