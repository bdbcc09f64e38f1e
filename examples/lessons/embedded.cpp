// SPDX-License-Identifier: BSL-1.0
// An embedded method for nodes of your own. b_hat = b + d/20 estimates the error by h d^T f/20. Two conditions make d unique
// but for its length: d^T 1 = 0, so that b_hat has order 1, and d^T A^-1 1 = 0, so that its R(infinity) is that of b: zero.
// What is printed is a file for the command: certify and stability judge both methods.
#include <iostream>
#include <stagecraft/tableaux/exact_collocation.hpp>
#include <stagecraft/tableaux/rational.hpp>
#include <vector>

using stagecraft::tableaux::rational;

void print(const char* name, const auto& x) {
    std::cout << name << '[';
    for (int i = 0; i < 3; ++i) std::cout << (i ? ", \"" : "\"") << x[i].str() << '"';
    std::cout << ']';
}

int main() {
    const std::vector<rational> c{rational(1, 6), rational(2, 3), 1};
    const auto exact = stagecraft::tableaux::collocation(c).tableau;
    // For collocation A^-1 1 = -w'(c)/w(0), where w is the nodal polynomial: u is that times c_0 c_1 c_2.
    std::vector<rational> u, b_hat;
    for (int i = 0; i < 3; ++i) u.push_back((c[i] - c[(i + 1) % 3]) * (c[i] - c[(i + 2) % 3]));
    for (int i = 0; i < 3; ++i)
        b_hat.push_back(exact.b[i] + (u[(i + 2) % 3] - u[(i + 1) % 3]) / rational(20));

    print("{\"name\": \"collocation at 1/6, 2/3, 1 with an embedded method\",\n \"c\": ", c);
    for (int i = 0; i < 3; ++i) print(i ? ",\n       " : ",\n \"A\": [", exact.A.row(i));
    print("],\n \"b\": ", exact.b);
    print(",\n \"b_embedded\": ", b_hat);
    std::cout << ",\n \"claims\": {\"order\": 4, \"embedded_order\": 1, \"L_stable\": true}}\n";
}
