// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/rational.hpp"

#include <functional>
#include <stdexcept>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/time_share.hpp"

namespace stagecraft::tableaux {

STAGECRAFT_INLINE rational::rational(integer n, integer d) : n_(std::move(n)), d_(std::move(d)) {
    if (d_ == 0) throw std::domain_error("rational: zero denominator");
    if (d_ < 0) {
        n_ = -n_;
        d_ = -d_;
    }
    cancel(n_, d_);
}

STAGECRAFT_INLINE rational rational::operator-() const {
    rational r = *this;
    r.n_ = -r.n_;
    return r;
}

STAGECRAFT_INLINE rational& rational::operator*=(const rational& o) {
    time_share::check();
    integer n = o.n_, d = o.d_;
    cancel(n_, d);
    cancel(n, d_);
    n_ *= n;
    d_ *= d;
    return *this;
}

STAGECRAFT_INLINE rational& rational::operator/=(const rational& o) {
    if (o.n_ == 0) throw std::domain_error("rational: division by zero");
    integer n = o.d_, d = o.n_;
    cancel(n_, d);
    cancel(n, d_);
    n_ *= n;
    d_ *= d;
    if (d_ < 0) {
        n_ = -n_;
        d_ = -d_;
    }
    return *this;
}

STAGECRAFT_INLINE integer rational::shifted(const integer& x, long k) {
    return k > 0 ? integer(x << static_cast<unsigned long>(k)) : x;
}

STAGECRAFT_INLINE void rational::cancel(integer& n, integer& d) {
    if (d == 1 || n == 1) return;
    const integer common = gcd(n, d);
    if (common == 1) return;
    n /= common;
    d /= common;
}

STAGECRAFT_INLINE rational& rational::add(const rational& o, const integer& n) {
    if (d_ == o.d_) {
        n_ += n;
        cancel(n_, d_);
        return *this;
    }
    integer common = d_ == 1 || o.d_ == 1 ? integer(1) : gcd(d_, o.d_);
    if (common == 1) {
        n_ = n_ * o.d_ + n * d_;
        d_ *= o.d_;
        return *this;
    }
    const integer rest = o.d_ / common;
    d_ /= common;
    n_ = n_ * rest + n * d_;
    cancel(n_, common);
    d_ *= rest * common;
    return *this;
}

}  // namespace stagecraft::tableaux
