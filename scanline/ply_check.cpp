// Looks over a PLY file before the library reads it: that reader waits for ever when the header never ends, and trusts
// the counts and indices that it finds.
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>

#include "scanline/mesh_checks.h"
#include "scanline/text_reader.h"

namespace scanline {
namespace {

struct Property {
  std::string name;
  int bytes = 0;
  bool is_float = false, is_list = false;
  int count_bytes = 0;  ///< of a list's length
};

struct Element {
  std::string name;
  long count = 0;
  std::vector<Property> properties;
};

/// Bytes of a type's name, 0 for an unknown one.
int type_bytes(std::string_view type) {
  if (type == "char" || type == "uchar" || type == "int8" || type == "uint8") return 1;
  if (type == "short" || type == "ushort" || type == "int16" || type == "uint16") return 2;
  if (type == "int" || type == "uint" || type == "int32" || type == "uint32") return 4;
  if (type == "float" || type == "float32") return 4;
  if (type == "double" || type == "float64") return 8;
  return 0;
}

class PlyCheck {
 public:
  PlyCheck(std::string_view text, const std::string& file) : text_(text), file_(file), lines_(text, file) {}

  void run() {
    const std::size_t data = read_header();
    for (const Element& e : elements_) {
      if (e.name == "vertex") vertices_ = e.count;
    }
    if (ascii_) {
      for (const Element& e : elements_) check_ascii(e);
    } else {
      bytes_ = text_.substr(data);
      for (const Element& e : elements_) check_binary(e);
    }
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { throw UserError({file_, 0, 0, message}); }

  void next_line() {
    if (!lines_.next()) lines_.fail("the file ends too early");
  }

  /// Where the data begins.
  std::size_t read_header() {
    if (!lines_.next() || lines_.words()[0] != "ply") throw UserError({file_, 1, 0, "a PLY file begins with 'ply'"});
    bool has_format = false;
    for (;;) {
      next_line();
      const auto& w = lines_.words();
      if (w[0] == "end_header") break;
      if (w[0] == "comment" || w[0] == "obj_info") continue;
      if (w[0] == "format" && w.size() == 3) {
        ascii_ = w[1] == "ascii";
        little_ = w[1] == "binary_little_endian";
        has_format = ascii_ || little_ || w[1] == "binary_big_endian";
        if (!has_format) lines_.fail("unknown format '" + std::string(w[1]) + "'");
      } else if (w[0] == "element" && w.size() == 3) {
        elements_.push_back({std::string(w[1]), lines_.whole(2, 0, 50'000'000), {}});
      } else if (w[0] == "property" && !elements_.empty()) {
        read_property();
      } else {
        lines_.fail("unknown line in the header");
      }
    }
    if (!has_format) lines_.fail("the header names no format");
    // The library wants "end_header" and its data on lines of their own.
    const std::size_t end = text_.find("\nend_header");
    const std::size_t line_end = end == std::string_view::npos ? end : text_.find('\n', end + 1);
    if (line_end == std::string_view::npos) lines_.fail("no data after the header");
    return line_end + 1;
  }

  void read_property() {
    const auto& w = lines_.words();
    Property p;
    p.is_list = w.size() == 5 && w[1] == "list";
    if (!p.is_list && w.size() != 3)
      lines_.fail("a property is 'property TYPE NAME' or 'property list TYPE TYPE NAME'");
    const std::string_view type = w[p.is_list ? 3 : 1];
    p.name = w.back();
    p.bytes = type_bytes(type);
    p.is_float = type.starts_with("float") || type == "double";
    if (p.is_list) p.count_bytes = w[2].starts_with("float") || w[2] == "double" ? 0 : type_bytes(w[2]);
    if (p.bytes == 0 || (p.is_list && p.count_bytes == 0)) lines_.fail("unknown type in a property");
    elements_.back().properties.push_back(p);
  }

  static bool holds_indices(const Element& e, const Property& p) {
    return p.is_list && e.name == "face" && (p.name == "vertex_indices" || p.name == "vertex_index");
  }

  void check_ascii(const Element& e) {
    for (long k = 0; k < e.count; ++k) {
      next_line();
      std::size_t word = 0;
      const auto need = [&](std::size_t more) {
        if (word + more > lines_.words().size()) lines_.fail("too few values for an element '" + e.name + "'");
      };
      for (const Property& p : e.properties) {
        need(1);
        if (!p.is_list) {
          lines_.number(word++);
          continue;
        }
        const bool indices = holds_indices(e, p);
        const long length = lines_.whole(word++, 0, 50'000'000);
        if (indices && length < 3) lines_.fail("a polygon needs at least three vertices");
        need(static_cast<std::size_t>(length));
        for (long i = 0; i < length; ++i, ++word) {
          if (indices) lines_.whole(word, 0, vertices_ - 1);
          if (!indices) lines_.number(word);
        }
      }
      if (word != lines_.words().size()) lines_.fail("too many values for an element '" + e.name + "'");
    }
    if (&e == &elements_.back() && lines_.next()) lines_.fail("more lines than the header announces");
  }

  std::uint64_t take(int bytes) {
    if (bytes_.size() < static_cast<std::size_t>(bytes)) fail("the file ends too early");
    std::uint64_t value = 0;
    for (int k = 0; k < bytes; ++k) {
      const auto byte = static_cast<unsigned char>(bytes_[static_cast<std::size_t>(little_ ? bytes - 1 - k : k)]);
      value = value << 8 | byte;
    }
    bytes_.remove_prefix(static_cast<std::size_t>(bytes));
    return value;
  }

  void check_value(const Property& p, bool index) {
    const std::uint64_t value = take(p.bytes);
    if (index && (p.is_float || value >= static_cast<std::uint64_t>(vertices_))) {
      fail("a polygon names a vertex that is not there");
    }
    if (!p.is_float) return;
    const double number = p.bytes == 4 ? static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(value)))
                                       : std::bit_cast<double>(value);
    // Broken normals are common and harmless (they count as none); a position must be one.
    const bool position = p.name == "x" || p.name == "y" || p.name == "z";
    if (position && !std::isfinite(number)) fail("a value of property '" + p.name + "' is not finite");
  }

  void check_binary(const Element& e) {
    for (long k = 0; k < e.count; ++k) {
      for (const Property& p : e.properties) {
        if (!p.is_list) {
          check_value(p, false);
          continue;
        }
        const std::uint64_t length = take(p.count_bytes);
        if (holds_indices(e, p) && length < 3) fail("a polygon needs at least three vertices");
        for (std::uint64_t i = 0; i < length; ++i) check_value(p, holds_indices(e, p));
      }
      if (e.properties.empty()) break;
    }
  }

  std::string_view text_, bytes_;
  std::string file_;
  TextLines lines_;
  bool ascii_ = false, little_ = false;
  std::vector<Element> elements_;
  long vertices_ = 0;
};

}  // namespace

void check_ply(std::string_view text, const std::string& file) { PlyCheck(text, file).run(); }

}  // namespace scanline
