#include "shadow/occlusion_query.h"

#include "base/parallel.h"

namespace haarlight {

void OcclusionQuery::answer(std::span<const OcclusionRay> rays,
                            std::span<std::uint8_t> blocked) const {
  constexpr std::size_t grain = 1024;
  parallelFor(rays.size(), grain, [&](std::size_t begin, std::size_t end) {
    answerHere(rays.subspan(begin, end - begin), blocked.subspan(begin, end - begin));
  });
}

}  // namespace haarlight
