#pragma once

#include <numeric>
#include <vector>

namespace crossfield
{
/// Disjoint sets of numbers.
class UnionFind
{
public:
  explicit UnionFind(std::size_t count)
    : Parent(count)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), 0);
  }
  int Find(int i)
  {
    while (this->Parent[i] != i)
    {
      i = this->Parent[i] = this->Parent[this->Parent[i]];
    }
    return i;
  }
  /// Joins the sets of i and j under the representative of j. Returns whether they were different.
  bool Join(int i, int j)
  {
    i = this->Find(i);
    j = this->Find(j);
    this->Parent[i] = j;
    return i != j;
  }

private:
  std::vector<int> Parent;
};
}
