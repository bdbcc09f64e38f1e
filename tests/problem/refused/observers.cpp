// SPDX-License-Identifier: BSL-1.0
// says: observer.start must be callable as start(t0, y0, t1)
// says: observer.correct must be callable as correct(t, y)
// says: observer.conclude must be callable as conclude(result)
#include <Eigen/Core>
#include <stagecraft/observe/observers.hpp>

using Eigen::Vector2d;

#ifdef RIGHT
struct starting {
    void start(double, const Vector2d&, double);
};
struct correcting {
    bool correct(double, Vector2d&);
};
struct concluding {
    void conclude(int);
};
#else
struct starting {
    void start(double, Vector2d&, double);
};
struct correcting {
    void correct(double, Vector2d&);
};
struct concluding {
    void conclude();
};
#endif

void call(starting a, correcting b, concluding c, Vector2d y) {
    auto all = stagecraft::observers(a, b, c);
    all.start(0., std::as_const(y), 1.);
    all.correct(0., y);
    int result_without_t = 0;
    stagecraft::detail::conclude(c, result_without_t);
}
