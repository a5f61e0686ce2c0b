// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rtob
{
/// Draws the levels above the lowest of `levels`, each `width` x `height` cells, row by row: cell
/// (x, y) of level h becomes the largest of the 2^h x 2^h cells of level 0 that begin there, those
/// outside left out. So a branch-and-bound search knows what a block can still reach.
void draw_pyramid(std::vector<std::uint8_t>* levels, std::size_t count, int width, int height);
}  // namespace rtob
