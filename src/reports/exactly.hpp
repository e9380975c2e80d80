#pragma once

#include <array>
#include <bit>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "audit/parts.hpp"

/// Numbers, lists and whatever has parts as values that lose nothing, for CBOR: a double as its 64
/// bits, so that a NaN keeps its sign.
namespace rayaudit::exactly {

using Json = nlohmann::json;

/// The same text for as long as the program runs: what tallies point to.
inline std::string_view interned(const std::string& text) {
  static std::set<std::string> texts;
  return *texts.insert(text).first;
}

template <class T>
Json written(const T& of);

template <class List>
Json written_list(const List& of) {
  Json all = Json::array();
  for (const auto& each : of) all.push_back(written(each));
  return all;
}

/// Counts that are not 0, each behind its place: most of a histogram are.
template <std::size_t size>
Json written_list(const std::array<std::uint64_t, size>& of) {
  Json all = Json::array();
  for (std::size_t i = 0; i < size; ++i)
    if (of[i] != 0) all.insert(all.end(), {i, of[i]});
  return all;
}

inline Json written(const Shape& of) {
  return {of.index(), std::visit([](const auto& shape) { return written(shape); }, of)};
}

template <class T>
Json written(const T& of) {
  if constexpr (std::is_enum_v<T>) {
    return static_cast<std::underlying_type_t<T>>(of);
  } else if constexpr (std::is_floating_point_v<T>) {
    return std::bit_cast<std::uint64_t>(of);
  } else if constexpr (std::is_arithmetic_v<T>) {
    return of;
  } else if constexpr (std::is_convertible_v<T, std::string_view>) {
    return std::string(of);
  } else if constexpr (requires { of.has_value(); }) {
    return of ? written(*of) : Json(nullptr);
  } else if constexpr (requires { of.begin(); }) {
    return written_list(of);
  } else {
    Json all = Json::array();
    std::apply([&](const auto&... part) { (all.push_back(written(part)), ...); }, parts(of));
    return all;
  }
}

template <class T>
void read(const Json& from, T& to);

template <class T>
void read_list(const Json& from, std::vector<T>& to) {
  to.resize(from.size());
  for (std::size_t i = 0; i < to.size(); ++i) read(from.at(i), to[i]);
}
template <class T, std::size_t size>
void read_list(const Json& from, std::array<T, size>& to) {
  for (std::size_t i = 0; i < size; ++i) read(from.at(i), to[i]);
}
template <std::size_t size>
void read_list(const Json& from, std::array<std::uint64_t, size>& to) {
  to = {};
  for (std::size_t i = 0; i + 1 < from.size(); i += 2)
    to.at(from.at(i).get<std::size_t>()) = from.at(i + 1);
}

inline void read(const Json& from, Shape& to) {
  const std::array<Shape, shape_count> all = []<std::size_t... I>(std::index_sequence<I...>) {
    return std::array<Shape, shape_count>{Shape(std::in_place_index<I>)...};
  }
  (std::make_index_sequence<shape_count>{});
  to = all.at(from.at(0).get<std::size_t>());
  std::visit([&](auto& shape) { read(from.at(1), shape); }, to);
}

template <class T>
void read(const Json& from, T& to) {
  if constexpr (std::is_enum_v<T>) {
    to = static_cast<T>(from.get<std::underlying_type_t<T>>());
  } else if constexpr (std::is_floating_point_v<T>) {
    to = std::bit_cast<double>(from.get<std::uint64_t>());
  } else if constexpr (std::is_arithmetic_v<T>) {
    to = from.get<T>();
  } else if constexpr (std::is_same_v<T, std::string_view>) {
    to = interned(from.get<std::string>());
  } else if constexpr (std::is_same_v<T, std::string>) {
    to = from.get<std::string>();
  } else if constexpr (requires { to.has_value(); }) {
    to.reset();
    if (!from.is_null()) read(from, to.emplace());
  } else if constexpr (requires { to.begin(); }) {
    read_list(from, to);
  } else {
    std::size_t i = 0;
    std::apply([&](auto&... part) { (read(from.at(i++), part), ...); }, parts(to));
  }
}

}  // namespace rayaudit::exactly
