#pragma once
/// The pieces of the table made ready for the step: the still ones first, then the moving ones, so that a
/// piece's index is also its handle in the broad phase; balls have the handles after them.

#include <span>

#include "custom/broad_phase/broad_phase.hpp"
#include "custom/geometry/narrow_phase.hpp"

namespace flipside::custom {

using PieceIndex = std::uint32_t;

/// Whether a piece answers a ball now: no sensor, no target that is down, no gate that lets this ball
/// through (gate.hpp).
[[nodiscard]] bool stops(const Table& table, const Piece& piece, const Pose& pose, const Ball& ball);

class Layout {
  public:
    explicit Layout(const Scene& scene);

    [[nodiscard]] const Piece& piece(PieceIndex i) const { return pieces_[i]; }
    [[nodiscard]] std::span<const Piece> pieces() const { return pieces_; }
    [[nodiscard]] PieceIndex size() const { return static_cast<PieceIndex>(pieces_.size()); }
    [[nodiscard]] bool moves(PieceIndex i) const { return i >= still_; }
    /// Pose and rate (rad/s) of a piece `ahead` seconds from now; cheap for what is still.
    [[nodiscard]] Pose pose(const Table& table, PieceIndex i, double ahead) const {
        return moves(i) ? table.pose(pieces_[i].part, ahead) : Pose{};
    }
    [[nodiscard]] double rate(const Table& table, PieceIndex i, double ahead) const {
        return moves(i) ? table.rate(pieces_[i].part, ahead) : 0;
    }
    /// Whether it is no sensor, target or gate.
    [[nodiscard]] bool always_stops(PieceIndex i) const { return always_stops_[i]; }
    /// The same as stops() above; cheap for most pieces.
    [[nodiscard]] bool stops(const Table& table, PieceIndex i, const Pose& pose, const Ball& ball) const {
        return always_stops_[i] || custom::stops(table, pieces_[i], pose, ball);
    }
    /// Of the still pieces, by index.
    [[nodiscard]] const std::vector<Proxy>& still_proxies() const { return still_proxies_; }
    /// Parts that are gates.
    [[nodiscard]] std::span<const PartIndex> gates() const { return gates_; }

    /// Proxies of the moving pieces and then of the balls. Pieces cover their way from `begin` to
    /// `end` seconds from the table's now. `box_of` gives the box of a ball; it is active unless asleep
    /// and `all_active` is false. A piece is active when it turns meanwhile.
    void place(const Table& table, std::span<const Ball> balls, double begin, double end, bool all_active,
               auto&& box_of, std::vector<Proxy>& moving) const {
        moving.clear();
        for (PieceIndex i = still_; i < pieces_.size(); ++i) moving.push_back(proxy(table, i, begin, end));
        for (const Ball& ball : balls)
            moving.push_back(
                {box_of(ball), ball.layer, ball.collides_with, true, all_active || !ball.asleep});
    }

    /// What happens between two materials.
    [[nodiscard]] const Mixed& mixed(std::uint32_t a, std::uint32_t b) const {
        return mixed_[a * materials_ + b];
    }

    [[nodiscard]] const Mixed& mixed(const Ball& ball, PieceIndex i) const {
        return mixed(ball.material, material_of_[i]);
    }

    /// Of a moving piece, as in place().
    [[nodiscard]] Proxy proxy(const Table& table, PieceIndex i, double begin, double end) const;

  private:
    const Scene& scene_;
    std::vector<Piece> pieces_;
    PieceIndex still_ = 0;
    std::vector<Proxy> still_proxies_;
    std::vector<PartIndex> gates_;
    std::vector<char> always_stops_;          ///< per piece
    std::vector<std::uint32_t> material_of_;  ///< per piece
    std::size_t materials_;
    std::vector<Mixed> mixed_;
};

}  // namespace flipside::custom
