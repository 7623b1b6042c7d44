// Tables for people.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace autoref::runner {

enum class Align { kLeft, kRight };

// How many letters of UTF-8 stand side by side.
std::size_t width_of(const std::string& text);

// A line per row, all rows having as many cells as the first; columns as wide as their widest cell.
// Cells are put to the right, those of the columns that `columns` says to the left.
std::string aligned(const std::vector<std::vector<std::string>>& rows,
                    const std::vector<Align>& columns = {});

}  // namespace autoref::runner
