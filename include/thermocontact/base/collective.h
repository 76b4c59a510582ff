// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_base_collective_h
#define thermocontact_base_collective_h

#include <deal.II/base/mpi.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <sstream>
#include <string>
#include <vector>

namespace ThermoContact
{
  /**
   * Utilities::MPI::all_gather() and broadcast() for any object that
   * boost::serialization knows. Theirs compile the compression of data into
   * every source that calls them; these into one.
   */
  std::vector<std::string>
  all_gather(const MPI_Comm communicator, const std::string &bytes);

  std::string
  broadcast(const MPI_Comm     communicator,
            const std::string &bytes,
            const unsigned int root = 0);

  template <typename Object>
  std::string
  to_bytes(const Object &object)
  {
    std::ostringstream bytes;
    boost::archive::binary_oarchive(bytes, boost::archive::no_header) << object;
    return bytes.str();
  }

  template <typename Object>
  Object
  from_bytes(const std::string &bytes)
  {
    std::istringstream stream(bytes);
    Object             object;
    boost::archive::binary_iarchive(stream, boost::archive::no_header) >>
      object;
    return object;
  }

  /** A rank that is alone has nobody to write for. */
  inline bool
  is_alone(const MPI_Comm communicator)
  {
    return dealii::Utilities::MPI::n_mpi_processes(communicator) == 1;
  }

  template <typename Object>
  std::vector<Object>
  all_gather(const MPI_Comm communicator, const Object &object)
  {
    if (is_alone(communicator))
      return {object};
    std::vector<Object> all;
    for (const std::string &bytes : all_gather(communicator, to_bytes(object)))
      all.push_back(from_bytes<Object>(bytes));
    return all;
  }

  template <typename Object>
  Object
  broadcast(const MPI_Comm     communicator,
            const Object      &object,
            const unsigned int root = 0)
  {
    if (is_alone(communicator))
      return object;
    return from_bytes<Object>(broadcast(communicator, to_bytes(object), root));
  }

  /** On all ranks, the message of the first rank that has one. Collective. */
  std::string
  first_fault(const std::string &fault, const MPI_Comm communicator);

  /**
   * Throws on all ranks if the message of rank 0 is not empty. Collective.
   *
   * @throw Error (InputError or ComputationError) with that message
   */
  template <typename Error>
  void
  throw_everywhere(const std::string &message, const MPI_Comm communicator)
  {
    const std::string shared = broadcast(communicator, message);
    if (!shared.empty())
      throw Error(shared);
  }



  /** Errors of single ranks between two collective calls, which all ranks throw
   * together. */
  template <typename Error>
  class CollectedErrors
  {
  public:
    /** Calls @p call; the message of the first Error is kept. */
    template <class Call>
    void
    collect(const Call &call)
    {
      try
        {
          call();
        }
      catch (const Error &error)
        {
          if (message.empty())
            message = error.what();
        }
    }

    /**
     * Collective.
     *
     * @throw Error on all ranks, with the message of the first rank that has
     * one
     */
    void
    throw_on_all_ranks(const MPI_Comm communicator) const
    {
      const std::string first = first_fault(message, communicator);
      if (!first.empty())
        throw Error(first);
    }

  private:
    std::string message;
  };
} // namespace ThermoContact

#endif
