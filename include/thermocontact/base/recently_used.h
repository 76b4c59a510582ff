// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_base_recently_used_h
#define thermocontact_base_recently_used_h

#include <algorithm>
#include <cstddef>
#include <list>
#include <utility>

namespace ThermoContact
{
  /**
   * Items that were used last, such as factors: step sizes come back. Each has
   * a member `tau`, the length of a stage or step, that tells it apart.
   */
  template <typename Item>
  class RecentlyUsed
  {
  public:
    /** @param limit to the number of items, positive */
    explicit RecentlyUsed(const std::size_t limit)
      : limit(limit)
    {}

    /**
     * Puts the item of a length in front. False: there is none; then items that
     * were not used for longest have made room for it.
     */
    bool
    use(const double tau)
    {
      const auto known =
        std::find_if(items.begin(), items.end(), [tau](const Item &item) {
          return item.tau == tau;
        });
      if (known != items.end())
        {
          items.splice(items.begin(), items, known);
          return true;
        }
      while (items.size() >= limit)
        items.pop_back();
      return false;
    }

    /** Puts a new item in front. */
    void
    add(Item &&item)
    {
      items.push_front(std::move(item));
    }

    /** The one that was used last; there is one. */
    Item &
    front()
    {
      return items.front();
    }

    const Item &
    front() const
    {
      return items.front();
    }

    /** All, the one that was used last in front. */
    const std::list<Item> &
    all() const
    {
      return items;
    }

    void
    clear()
    {
      items.clear();
    }

  private:
    std::size_t     limit;
    std::list<Item> items;
  };
} // namespace ThermoContact

#endif
