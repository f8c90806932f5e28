#pragma once
/// The cells of a uniform grid that a box overlaps.

#include <algorithm>
#include <cstdint>

namespace flipside::custom {

/// Columns and rows of cells, both ends included.
struct CellRange {
    std::uint32_t left = 0, low = 0, right = 0, high = 0;

    [[nodiscard]] std::uint64_t count() const {
        return std::uint64_t{right - left + 1} * std::uint64_t{high - low + 1};
    }
    /// Visits the cells row by row.
    void each(auto&& visit) const {
        for (std::uint32_t row = low; row <= high; ++row)
            for (std::uint32_t column = left; column <= right; ++column) visit(column, row);
    }
};

/// Index of the cell at this distance from the border, in widths; that of the outermost cell beyond them.
inline std::uint32_t cell_index(double at, std::uint32_t cells) {
    return at > 0 ? static_cast<std::uint32_t>(std::min(at, cells - 1.0)) : 0;
}

}  // namespace flipside::custom
