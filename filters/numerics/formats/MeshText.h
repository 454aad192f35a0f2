#pragma once

#include <Eigen/Core>

#include <string>
#include <string_view>

namespace crossfield
{
/// Text of a file with many numbers.
class MeshText
{
public:
  MeshText& Add(std::string_view text);
  MeshText& Add(char character) { return this->Add(std::string_view(&character, 1)); }
  MeshText& Add(int number);
  /// Adds the shortest text that is read back as the same number.
  MeshText& Add(double number);
  /// Adds a number with at most 20 characters, exactly if they are enough, else with 13 digits.
  MeshText& AddIn20(double number);

  /// Adds a place in space: three numbers with blanks between them.
  MeshText& Add(const Eigen::Vector3d& place);

  /// Returns the text and leaves none.
  std::string Take() { return std::move(this->Text); }
  void Reserve(std::size_t size) { this->Text.reserve(size); }

private:
  std::string Text;
};
}
