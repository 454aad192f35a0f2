#include "MeshText.h"

#include <array>
#include <charconv>

namespace crossfield
{
namespace
{
constexpr std::size_t Longest = 32; // the shortest text of a double has at most 24 characters

template <class... Arguments>
void AddNumber(std::string& text, Arguments... arguments)
{
  std::array<char, Longest> buffer{};
  const std::to_chars_result end =
    std::to_chars(buffer.data(), buffer.data() + buffer.size(), arguments...);
  text.append(buffer.data(), end.ptr);
}
}

MeshText& MeshText::Add(std::string_view text)
{
  this->Text += text;
  return *this;
}

MeshText& MeshText::Add(int number)
{
  AddNumber(this->Text, number);
  return *this;
}

MeshText& MeshText::Add(double number)
{
  AddNumber(this->Text, number);
  return *this;
}

MeshText& MeshText::AddIn20(double number)
{
  constexpr std::size_t Most = 20;
  const std::size_t before = this->Text.size();
  AddNumber(this->Text, number);
  if (this->Text.size() - before > Most)
  {
    this->Text.resize(before);
    constexpr int Digits = 12; // with sign, point and a three-digit exponent, 20 characters
    AddNumber(this->Text, number, std::chars_format::scientific, Digits);
  }
  return *this;
}

MeshText& MeshText::Add(const Eigen::Vector3d& place)
{
  return this->Add(place.x()).Add(' ').Add(place.y()).Add(' ').Add(place.z());
}
}
