#pragma once
// The solid as a union of parts, in the form in which they are searched.

#include <cstdint>
#include <span>
#include <vector>

#include <groundtruth/fast/grid.hpp>
#include <groundtruth/fast/hierarchy.hpp>
#include <groundtruth/fast/large_vector.hpp>
#include <groundtruth/problem/shape.hpp>

namespace groundtruth::fast {

// Four half-spaces, their numbers side by side. Those that fill up a cell's last group hold everywhere.
struct alignas(64) HalfSpaces4 {
  double normal_x[4];
  double normal_y[4];
  double normal_z[4];
  double offset[4];
};

inline constexpr Leaf no_leaf = 0xffffffff;

// What decides the material of a face. The material: a place in Scene::materials, or one of these two; where
// rules decide, the innermost one is a place in Scene::rules, unless it is unknown.
struct CellMaterial {
  static constexpr std::uint32_t by_rules = 0xffffffff, none = 0xfffffffe, unknown_rule = 0xffffffff;

  std::uint32_t material = by_rules;
  std::uint32_t rule = unknown_rule;
};

// An intersection of half-spaces, in the groups from first_group on.
struct Cell {
  static constexpr std::uint32_t not_listed = 0xffffffff;

  std::uint32_t first_group = 0;
  std::uint32_t leaf_count = 0;
  float normal_size = 0;                 // >= |n_x| + |n_y| + |n_z| of each
  float offset_size = 0;                 // >= |d| of each
  std::uint32_t first_leaf = 0;          // the number of the first; they are numbered on from there,
  std::uint32_t listed_at = not_listed;  // unless they are listed in PackedCells::leaves
  CellMaterial material{};               // of all its faces

  std::uint32_t end_group() const { return first_group + (leaf_count + 3) / 4; }
};

struct PackedCells {
  LargeVector<HalfSpaces4> groups;
  std::vector<std::uint32_t> leaves;
  LargeVector<Cell> cells;

  // Appends a cell of these half-spaces, with their numbers.
  void add(std::span<const std::uint32_t> numbers, std::span<const HalfSpace> half_spaces);

  // Of the half-space at this place in the cell.
  std::uint32_t leaf_at(const Cell& cell, std::uint32_t place) const {
    return cell.listed_at == Cell::not_listed ? cell.first_leaf + place : leaves[cell.listed_at + place];
  }
  HalfSpace half_space_at(const Cell& cell, std::uint32_t place) const {
    const HalfSpaces4& group = groups[cell.first_group + place / 4];
    const std::uint32_t lane = place % 4;
    return {{group.normal_x[lane], group.normal_y[lane], group.normal_z[lane]}, group.offset[lane]};
  }
};

// A convex cell, by its place in Parts::cells; from there on a node of the solid, by its place in
// Parts::general.
using Part = std::uint32_t;

struct CellKernels;

struct Parts {
  const CellKernels* kernels = nullptr;  // the inner loops for this processor
  PackedCells cells;
  std::vector<std::uint32_t> general;  // where these operands start in the solid's nodes
  std::vector<Part> apart;             // not in the hierarchy: looked at one by one, first
  BoxHierarchy hierarchy;              // over the others
  Grid grid;                           // over the same ones, or none

  std::size_t size() const { return cells.cells.size() + general.size(); }
  bool is_cell(Part part) const { return part < cells.cells.size(); }
  std::uint32_t node_of(Part part) const { return general[part - cells.cells.size()]; }
};

}  // namespace groundtruth::fast
