#pragma once

namespace crossfield
{
/// Restricts OpenBLAS to one thread while at least one object of this class exists.
///
/// The blocks of a factorisation are small: a second thread of OpenBLAS spins longer than it
/// computes, and disturbs the two threads that factor the halves of a mesh (DissectedCholesky). One
/// thread also makes every result identical to the last bit, whatever the number of threads.
///
/// The number of these objects is the only state that functions of this library share between
/// threads; it is protected by a lock. Functions may run in several threads at once, const
/// functions of one object too, as long as no thread changes an object that another one reads.
class SerialBlas
{
public:
  SerialBlas();
  ~SerialBlas();
  SerialBlas(const SerialBlas&) = delete;
  SerialBlas& operator=(const SerialBlas&) = delete;
};
}
