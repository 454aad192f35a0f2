#pragma once

namespace crossfield
{
/// Keeps OpenBLAS to one thread while at least one of these exists.
///
/// The blocks of a factorisation are small: a second thread of OpenBLAS spins longer than it
/// computes, and disturbs the two threads that factor the halves of a mesh (DissectedCholesky). It
/// also makes every result the same to the last bit, however many threads there are.
class SerialBlas
{
public:
  SerialBlas();
  ~SerialBlas();
  SerialBlas(const SerialBlas&) = delete;
  SerialBlas& operator=(const SerialBlas&) = delete;
};
}
