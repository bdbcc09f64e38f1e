// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE program_text
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <chrono>
#include <stagecraft/tableaux/program_text.hpp>
#include <string>
#include <vector>

using namespace stagecraft::tableaux;

namespace {

/// "name s order embedded_order" of each tableau, with 0 for what is not claimed; "!name" of each that cannot be used.
std::vector<std::string> read(std::string_view source) {
    const auto p = read_program_text(source);
    std::vector<std::string> out;
    for (const auto& t : p.tableaux)
        out.push_back(t.name + " " + std::to_string(t.stages()) + " " +
                      std::to_string(t.claims.order.value_or(0)) + " " +
                      std::to_string(t.claims.embedded_order.value_or(0)));
    for (const auto& u : p.unusable) out.push_back("!" + u.name);
    return out;
}

std::vector<std::string> unused(std::string_view source) { return read_program_text(source).unused; }

std::string complaint(std::string_view source) {
    try {
        const auto p = read_program_text(source);
        return p.unusable.empty() ? "none" : p.unusable.front().what;
    } catch (const unusable_input& e) {
        return e.what();
    }
}

/// The values of A, b, c and the embedded weights in one list.
std::vector<rational> numbers(const tableau_file& t) {
    std::vector<rational> all;
    for (const auto& row : t.A)
        for (const auto& e : row) all.push_back(e.enclosure.middle());
    for (const auto* list : {&t.b, &t.c, &t.b_embedded})
        for (const auto& e : *list) all.push_back(e.enclosure.middle());
    return all;
}

using names = std::vector<std::string>;
using values = std::vector<rational>;

rational q(int numerator, int denominator = 1) { return {numerator, denominator}; }

/// The only tableau of a program, of which nothing is left over.
values only(std::string_view source) {
    const auto p = read_program_text(source);
    BOOST_REQUIRE(p.tableaux.size() == 1);
    BOOST_TEST(p.unusable.empty());
    BOOST_TEST(p.unused == names{}, boost::test_tools::per_element());
    return numbers(p.tableaux.front());
}

// Kutta's third order method, Ralston's second order one, Heun's with Euler's embedded.
const values kutta{q(0), q(0), q(0), q(1, 2), q(0), q(0), q(-1), q(2), q(0), q(1, 6), q(2, 3), q(1, 6)};
const values ralston{q(0), q(0), q(2, 3), q(0), q(1, 4), q(3, 4)};
const values heun_euler{q(0), q(0), q(1), q(0), q(1, 2), q(1, 2), q(0), q(1), q(1), q(0)};

}  // namespace

BOOST_AUTO_TEST_CASE(programs_in_ten_dialects_have_all_their_tableaux_under_their_names) {
    const auto check = [](std::string_view source, const names& expected) {
        BOOST_TEST(read(source) == expected, boost::test_tools::per_element());
        BOOST_TEST(unused(source) == names{}, boost::test_tools::per_element());
    };
    // Python: classes, dictionaries, prefixes.
    check(R"(
"""A = [[9]]"""
class Heun(Method):
    order: int = 2
    A = np.array([[0, 0], [1, 0]], dtype=float)
    B = np.array([1/2, 1/2])
class Kutta(Method):
    def __init__(self):
        self.A = [[], [1/2], [-1, 2]]
        self.b = [1/6, 2/3, 1/6]
        self.order = 3  # claims = {"order": 9}
TABLES = {"euler": {"A": [[0]], "b": [1], "claims": {"order": 1}},
          "mid": dict(A=((0, 0), (0.5, 0)), b=(0, 1), order=2)}
class Euler:
    def order(self):
        return 1
    def A(self): return [[0]]
    def b(self): return [1]
ralston_A = [[0, 0], [2/3, 0]]
ralston_b = [1/4, 3/4]
ralston_order = 2
)",
          {"Heun 2 2 0", "Kutta 3 3 0", "euler 1 1 0", "mid 2 2 0", "Euler 1 1 0", "ralston 2 2 0"});
    // C: structs, blocks with a registering call; C++: templates.
    check(R"(
#define HALF 0.5
/* A = {{7}} */
struct table heun = { .A = {{0, 0}, {1, 0}}, .b = {HALF, HALF}, .order = 2 };
void all(void) {
  {
    const PetscReal A[1][1] = {{0}}, b[1] = {RC(1.0)};
    PetscCall(TSRKRegister("1fe", 1, 1, &A[0][0], b, NULL, NULL, 0, NULL));
  }
  {
    const PetscReal A[2][2] = {{0, 0}, {0.5, 0}}, At[2][2] = {{0, 0}, {0, 0.5}}, b[2] = {0, 1};
    PetscCall(TSARKIMEXRegister(ARS122, 2, 2, &At[0][0], b, NULL, &A[0][0], b, NULL, NULL, NULL, 0, NULL, NULL));
  }
})",
          {"heun 2 2 0", "1fe 1 1 0", "ARS122 explicit 2 2 0", "ARS122 implicit 2 2 0"});
    check(R"(
struct Heun { static constexpr int order() { return 2; }
  static constexpr std::array<std::array<double, 2>, 2> A{{ {0.0, 0.0}, {1.0, 0.0} }};
  static constexpr std::array<double, 2> b{0.5, 0.5}; };  // 1/2
struct Mid { static const int order = 2; double A[2][2] = {{0}, {0.5}}; double b[2] = {0, 1}; };)",
          {"Heun 2 2 0", "Mid 2 2 0"});
    // SUNDIALS, both ways.
    check(R"(
ARK_BUTCHER_TABLE(HEUN_EULER, { /* 2-1 */
    ARKodeButcherTable B = ARKodeButcherTable_Alloc(2, SUNTRUE);
    B->q = 2;
    B->p = 1;
    B->A[1][0] = SUN_RCONST(1.0);
    B->b[0] = B->b[1] = SUN_RCONST(1.0)/SUN_RCONST(2.0);
    B->d[0] = SUN_RCONST(1.0);
    B->c[1] = SUN_RCONST(1.0);
    return B;
  })
switch (which) {
  case(IMPLICIT_EULER): B->q = 1; B->A[0][0] = RCONST(1.0); B->b[0] = RCONST(1.0); break;
  case RALSTON:
    B->q = 2;
    B->A[1][0] = RCONST(2.0)/RCONST(3.0);
    B->b[0] = 0.25; B->b[1] = RCONST(3.0)*B->b[0];
})",
          {"HEUN_EULER 2 2 1", "IMPLICIT_EULER 1 1 0", "RALSTON 2 2 0"});
    // Julia: constructors, named tuples, static arrays.
    check(R"(
#= A = [1] =#
function constructHeun(T::Type = Float64)
    A = [0 0
         1 0]
    c = [0; 1]
    α = [1 // 2; 1 // 2]
    αEEst = [1; 0]
    A = map(T, A)
    return DiffEqBase.ExplicitRKTableau(A, c, α, 2, αEEst = αEEst, adaptiveorder = 1)
end
const mid = (A = SMatrix{2,2}(0, 1//2, 0, 0), b = SVector(0, 1), order = 2)
function constructGauss(T)
    A = T[1//4 1//4-√3//6; 1//4+√3//6 1//4]
    b = [1//2, 1//2]
    order = 4
end)",
          {"constructHeun 2 2 1", "mid 2 2 0", "constructGauss 2 4 0"});
    check(R"(
switch name
  case 'heun'
    A = [0 0; 1 0];  % order = 3
    b = [1/2 1/2]; order = 2;
  case 'ralston'
    A = [0 2/3; 0 0]'; b = [1/4; 3/4]; order = 2;
end)",
          {"heun 2 2 0", "ralston 2 2 0"});
    check(R"(
module tables
real(dp), parameter :: mid_a(2,2) = reshape([0.0_dp, 0.5d0, &  ! by columns
                                           & 0.0_dp, 0.0_dp], [2,2])
real(dp), parameter :: mid_b(2) = (/ 0.0_dp, 1.0_dp /)
integer, parameter :: mid_order = 2
double precision a(2,2), b(2)
data a /0.0d0, 1.0d0, 2*0.0d0/
data b /2*0.5d0/
end module)",
          {"tables mid 2 2 0", "tables 2 0 0"});
    check(R"(
pub const HEUN: Tableau<2> = Tableau { order: 2, a: [[0.0, 0.0], [1.0, 0.0]], b: [0.5, 0.5f64] };
impl Ralston { const A: [[f64; 2]; 2] = [[0.0, 0.0], [2.0 / 3.0, 0.0]]; const B: [f64; 2] = [0.25, 0.75]; const ORDER: usize = 2; }
fn kutta() -> Table { let a = vec![vec![], vec![0.5], vec![-1.0, 2.0]]; let b = vec![1.0/6.0, 2.0/3.0, 1.0/6.0]; })",
          {"HEUN 2 2 0", "Ralston 2 2 0", "kutta 3 0 0"});
    check("heun <- list(A = matrix(c(0, 0, 1, 0), nrow = 2, byrow = TRUE), b = c(1/2, 1/2), order = 2)\n",
          {"heun 2 2 0"});
    // torchdiffeq and diffrax have no first row and no first node.
    check(R"(
_BS = _ButcherTableau(alpha=torch.tensor([1/2, 3/4, 1.], dtype=torch.float64),
    beta=[torch.tensor([1/2]), torch.tensor([0., 3/4]), torch.tensor([2/9, 1/3, 4/9])],
    c_sol=torch.tensor([2/9, 1/3, 4/9, 0.]), c_error=torch.tensor([2/9 - 7/24, 1/3 - 1/4, 4/9 - 1/3, -1/8]))
_heun = ButcherTableau(a_lower=(np.array([1.0]),), b_sol=np.array([0.5, 0.5]), c=np.array([1.0]), b_error=np.array([0.5, -0.5]))
)",
          {"_BS 4 0 0", "_heun 2 0 0"});
    // The diagonal of diffrax's implicit methods is an array of its own: without it another method would be judged.
    const values trapezoidal{q(0), q(0), q(1, 2), q(1, 2), q(1, 2), q(1, 2), q(0), q(1), q(0), q(1)};
    BOOST_TEST(
        only("_t = ButcherTableau(a_lower=(np.array([1/2]),), a_diagonal=np.array([0, 1/2]), "
             "b_sol=np.array([1/2, 1/2]), c=np.array([1.0]), b_error=np.array([1/2, -1/2]))") == trapezoidal,
        boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(numbers_are_those_of_the_program_whatever_its_notation) {
    for (const char* source : {
             "A = [0 0 0; 1//2 0 0; -1 2 0]\nb = [1//6, 2//3, 1//6]",
             "A = [1/2, -1, 2]\nb = [1/6, 2/3, 1/6]",           // packed below the diagonal
             "A = [0, 1/2, 0, -1, 2, 0]\nb = [1/6, 2/3, 1/6]",  // with it
             "A = [[0, 0, 0], [F(1, 2), 0, 0], [-1, Q(\"2\"), 0]]\nb = [sp.Rational(1, 6), Fraction(2, 3), "
             "1/RCONST(6.0)]",
             "half = 1/2\nA = [[0, 0, 0], [half, 0, 0], [-2*half, 1/half, 0]]\nb = np.array([1, 4, 1])/6",
             "A = 2*np.array([[0, 0, 0], [1/4, 0, 0], [-1/2, 1, 0]])\nb = "
             "[1/6, 2/3, 1/6]",
             "A = np.zeros((3, 3))\nA[1, 0] = 0.5\nA[2, :] = [-1, 2, 0]\nb = [1/6, 1 - 1/3, 2**-1/3]",
             "A(2,1) = 1/2;\nA(3,1) = -1; A(3,2) = sqrt(4);\nb = [1/6 2/3 1/6];",
             "A = np.array([[0, 1/2, -1], [0, 0, 2], [0, 0, 0]]).T\nb = [1/6, 2/3, 1/6]",
             "A = np.reshape([0, 0, 0, 1/2, 0, 0, -1, 2, 0], (3, 3))\nb = [1/6, 2/3, 1/6]",
             "A = [[0, 0, 0], [cbrt(8)/4, 0, 0], [-1, np.sqrt(4), 0]]\nb = [1/6, pow(8, 1/3)/3, 1/6]",
             "A << 0, 0, 0,\n 0.5, 0, 0,\n -1, 2, 0;\nb << 1./6, 2./3, 1./6;",
         }) {
        const auto p = read_program_text(source);
        BOOST_TEST_CONTEXT(source) { BOOST_TEST((numbers(p.tableaux.at(0)) == kutta)); }
    }
    BOOST_TEST((only("A = [0 2/3; 0 0]';\nb = [1/4 3/4];") == ralston));
    BOOST_TEST((only("A = [[0, 0], [2/3, 0]]\nb = [1/2, 1/2] - np.array([1/4, -1/4])") == ralston));
    const std::string heun = "A = [[0, 0], [1, 0]]\nb = [1/2, 1/2]\nc = [0, 1]\n";
    for (const char* embedded :
         {"b_hat = [1, 0]", "bembed = [1, 0]", "b_star = [1, 0]", "bt = [1, 0]", "d = [1, 0]",
          "E = [-1/2, 1/2]", "b_error = [-1/2, 1/2]", "b_err = np.array([-1, 1])/2"})
        BOOST_TEST((only(heun + embedded) == heun_euler));
}

BOOST_AUTO_TEST_CASE(coefficients_with_names_of_their_own_are_one_tableau) {
    const values kutta_c{q(0), q(0),    q(0),    q(1, 2), q(0), q(0),    q(-1), q(2),
                         q(0), q(1, 6), q(2, 3), q(1, 6), q(0), q(1, 2), q(1)};
    const auto same = [](std::string_view source, const values& expected) {
        BOOST_TEST(only(source) == expected, boost::test_tools::per_element());
    };
    // Julia: the nodes that are not 0 count from 1; the last stage is the solution.
    const values bogacki_shampine{q(0),    q(0),    q(0),    q(0),     q(1, 2), q(0),    q(0),
                                  q(0),    q(0),    q(3, 4), q(0),     q(0),    q(2, 9), q(1, 3),
                                  q(4, 9), q(0),    q(2, 9), q(1, 3),  q(4, 9), q(0),    q(0),
                                  q(1, 2), q(3, 4), q(1),    q(7, 24), q(1, 4), q(1, 3), q(1, 8)};
    same(R"(
@fold function BS3(::Type{T}) where {T}
    a21 = convert(T, 1 // 2)
    a32 = convert(T, 3 // 4)
    a41 = convert(T, 2 // 9)
    a42 = convert(T, 1 // 3)
    a43 = convert(T, 4 // 9)
    c1 = convert(T, 1 // 2)
    c2 = convert(T, 3 // 4)
    btilde1 = convert(T, 2 // 9 - 7 // 24)
    btilde2 = convert(T, 1 // 12)
    btilde3 = convert(T, 1 // 9)
    btilde4 = convert(T, -1 // 8)
end)",
         bogacki_shampine);
    // Fehlberg's letters in Fortran: a for nodes, b for the matrix, c for weights.
    same(R"(
  module procedure kutta
    real(wp),parameter :: a2 = 1.0_wp / 2.0_wp
    real(wp),parameter :: a3 = 1.0_wp
    real(wp),parameter :: b21 = 1.0_wp / 2.0_wp
    real(wp),parameter :: b31 = -1.0_wp
    real(wp),parameter :: b32 = 2.0_wp
    real(wp),parameter :: c1 = 1.0_wp / 6.0_wp
    real(wp),parameter :: c2 = 2.0_wp / 3.0_wp
    real(wp),parameter :: c3 = 1.0_wp / 6.0_wp
  end procedure kutta)",
         kutta_c);
    // GSL: rows with names of their own, a21 left out, errors that count from 1.
    same(R"(
static const double ah[] = { 1.0, 1.0 };
static const double b2[] = { 1.0 };
static const double b3[] = { 0.5, 0.5 };
static const double c1 = 0.5;
static const double c2 = 0.5;
static const double ec[] = { 0.0, -0.5, 0.5 };
unsigned int heun_order (void *vstate) { return 2; })",
         {q(0), q(0), q(0), q(1), q(0), q(0), q(1, 2), q(1, 2), q(0), q(1, 2), q(1, 2), q(0), q(0), q(1),
          q(1), q(1), q(0), q(0)});
    // Boost.odeint: a class for each row.
    same(R"(
struct k_a1 : array<1> { k_a1( void ) {
    (*this)[0] = static_cast<Value>( 1 )/static_cast<Value>( 2 );
  } };
struct k_a2 : array<2> { k_a2( void ) {
    (*this)[0] = static_cast<Value>( -1 );
    (*this)[1] = static_cast<Value>( 2 );
  } };
struct k_b : array<3> { k_b( void ) {
    (*this)[0] = static_cast<Value>( 1 )/static_cast<Value>( 6 );
    (*this)[1] = static_cast<Value>( 2 )/static_cast<Value>( 3 );
    (*this)[2] = static_cast<Value>( 1 )/static_cast<Value>( 6 );
  } };)",
         kutta);
}

BOOST_AUTO_TEST_CASE(codes_with_layouts_of_their_own_are_read_as_they_stand) {
    const auto same = [](std::string_view source, const values& expected) {
        BOOST_TEST(only(source) == expected, boost::test_tools::per_element());
    };
    // A^T and both sets of weights by columns; the rows of a dictionary, at last b; rows from the second on, no b.
    same(
        "real :: a(2,2) = reshape([0.0, 0.0, 1.0, 0.0], [2, 2])\nreal :: b(2,2) = reshape([1, 1, 2, 0], [2, "
        "2]) / 2\n"
        "real :: c(2) = [0, 1]\n",
        {q(0), q(0), q(1), q(0), q(1, 2), q(1, 2), q(0), q(1), q(1), q(0)});
    same(
        "class K:\n  def f(self):\n    self.eval_stages = [0, 1/2, 1]\n    self.BT = {\n      0: [1/2],\n    "
        "  1: [-1, 2],\n      2: [1/6, 2/3, 1/6]}\n",
        {q(0), q(0), q(0), q(1, 2), q(0), q(0), q(-1), q(2), q(0), q(1, 6), q(2, 3), q(1, 6), q(0), q(1, 2),
         q(1)});
    same(
        "const A: ([f64; 1], [f64; 2]) = ([1.0], [1.0 / 2.0, 1.0 / 2.0]);\nconst E: [f64; 3] = [0.5, 0.0, "
        "-0.5];\n",
        {q(0), q(0), q(0), q(1), q(0), q(0), q(1, 2), q(1, 2), q(0), q(1, 2), q(1, 2), q(0), q(0), q(1, 2),
         q(1, 2)});
    // Octave's b are the nodes; Rust's repeated zeros; Python's slices and r"..."; weights of Euler's method alone.
    same(
        "persistent a = [0 0; 1 0];\npersistent b = [0, 1, 1];\npersistent c = [1/2, 1/2];\npersistent "
        "c_prime = [1/2, 0, 1/2];\n",
        {q(0), q(0), q(0), q(1), q(0), q(0), q(1, 2), q(1, 2), q(0), q(1, 2), q(1, 2), q(0), q(0), q(1), q(1),
         q(1, 2), q(0), q(1, 2)});
    same(
        "fn heun() -> Self {\n let mut a = [[0.0; 2]; 2];\n let mut b = [0.0; 2];\n a[1][0] = 1.0;\n b[0] = "
        "0.5;\n b[1] = 0.5;\n let a = a.map(|row| row.map(|x| T::from_f64(x).unwrap()));\n}",
        {q(0), q(0), q(1), q(0), q(1, 2), q(1, 2)});
    same(
        "def heun():\n    u\"\"\"A = [[9]]\"\"\"\n    s = r'\\begin{x}'\n    #===========\n    A = "
        "np.zeros((2, 2))\n    A[1, :1] = [1]\n    b = np.ones(2)/2\n",
        {q(0), q(0), q(1), q(0), q(1, 2), q(1, 2)});
    // An element that C's program never assigns is 0; a difference of two lists; b1 beside b20 is b10.
    same(
        "ARK_BUTCHER_TABLE(HEUN, {\n  B->b[0] = 0.5;\n  B->b[2] = 0.5;\n  B->A[2][0] = B->b[0] + 0.5;\n  "
        "B->A[2][1] = "
        "B->b[1];\n  })",
        {q(0), q(0), q(0), q(0), q(0), q(0), q(1), q(0), q(0), q(1, 2), q(0), q(1, 2)});
    same(
        "x = [1/2, 1/2]\ny = [1, 0]\nA = [[0, 0], [1, 0]]\nb = [1/2, 1/2]\nE = [p - q for p, q in zip(x, "
        "y)]\n",
        {q(0), q(0), q(1), q(0), q(1, 2), q(1, 2), q(1), q(0)});
    same(
        "module procedure kutta\n a1 = 0.5_wp\n a2 = 1.0_wp\n b1 = 0.5_wp\n b20 = -1\n b21 = 2\n c0 = 1/6\n "
        "c1 = "
        "2/3\n c2 = 1/6\nend procedure\n",
        {q(0), q(0), q(0), q(1, 2), q(0), q(0), q(-1), q(2), q(0), q(1, 6), q(2, 3), q(1, 6), q(0), q(1, 2),
         q(1)});
    // Williamson's 2N form, which the program subtracts; not Julia's packed triangle of the same length, {1/2, -1, 2}.
    same(
        "a = SVector(0, 5 / 9, 153 / 128)\nb = SVector(1 / 3, 15 / 16, 8 / 15)\nc = SVector(0, 1 / 3, 3 / "
        "4)\n",
        {q(0), q(0), q(0), q(1, 3), q(0), q(0), q(-3, 16), q(15, 16), q(0), q(1, 6), q(3, 10), q(8, 15), q(0),
         q(1, 3), q(3, 4)});
    same("a = SVector(1 / 2, -1, 2)\nb = SVector(1 / 6, 2 / 3, 1 / 6)\nc = SVector(0, 1 / 2, 1)\n",
         {q(0), q(0), q(0), q(1, 2), q(0), q(0), q(-1), q(2), q(0), q(1, 6), q(2, 3), q(1, 6), q(0), q(1, 2),
          q(1)});
    same("ARK_BUTCHER_TABLE(EULER, {\n  B->q = 1;\n  B->b[0] = RCONST(1.0);\n  })", {q(0), q(1)});
}

BOOST_AUTO_TEST_CASE(arrays_that_are_no_tableau_are_not_taken_for_one) {
    // Real and imaginary parts of eigenvalues; a diagonal that has a name of its own; elements that are not yet placed.
    BOOST_TEST(complaint("double alpha[] = {1.5, 2.5}, beta[] = {0.5, 3}, gamma[] = {4};")
                   .starts_with("no tableau"));
    BOOST_TEST(complaint("gamma = 0.25\na31 = 0.5\na32 = 0.25\nb1 = 0.5\nb2 = 0.25\nb3 = 0.25\n")
                   .starts_with("no tableau"));
    BOOST_TEST(
        complaint("A = zeros(2, 2)\nA[2, 1] = 1\nh_A = A/2\nh_b = [1/2, 1/2]\n").starts_with("no tableau"));
}

BOOST_AUTO_TEST_CASE(what_is_not_used_is_told_with_its_line) {
    const std::string heun = "A = [[0, 0], [1, 0]]\nb = [1/2, 1/2]\n";
    const auto told = [&](const std::string& more) {
        const auto all = unused(heun + more);
        return all.empty() ? std::string("nothing") : all.front();
    };
    BOOST_TEST(told("order = 2") == "nothing");
    BOOST_TEST(told("order_of_embedded = 4") == "order_of_embedded (line 3)");
    BOOST_TEST(told("\norder = p") == "order (line 4): 'p' is unknown");
    BOOST_TEST(read(heun + "o = 2\nTableau{T}(:Heun, o, A, b)\n") == names{" 2 2 0"},
               boost::test_tools::per_element());
    BOOST_TEST(told("order = (3, 2)") == "order (line 3)");
    BOOST_TEST(told("order = 2.5") == "order (line 3)");
    BOOST_TEST(told("order(2)") == "nothing");  // an initializer of C++
    BOOST_TEST(told("self.order = order") == "nothing");
    BOOST_TEST(told("P = np.array([[1, -4/3], [0, 1], [1, 0], [0, 0]])") == "P (line 3)");
    BOOST_TEST(told("int f() { *order = rk->tableau->order; }") == "nothing");
    BOOST_TEST(told("double *e = work + 2;\nfor (;;) { e[i] += h * B[i]; }") == "nothing");
    BOOST_TEST(told("#if 0\n  #if X\nA2 = [[0, 1/2]]\n  #endif\n#else\nA3 = [[0, 1/2]]\n#endif") ==
               "A3 (line 8)");
    BOOST_TEST(told("b_hat = foo([1/3, 2/3])") == "b_hat (line 3): 'foo(...)' is not understood");
    BOOST_TEST(told("c = [0, x]") == "c (line 3): 'x' is unknown");
    BOOST_TEST(told("plot([0.1, 0.2, 0.3])") == "numbers without a name (line 3)");
    BOOST_TEST(told("a21 = 1/5\na31 = 3/40") == "a21 (line 3) and 1 more single numbers");
    BOOST_TEST(told("x = 0.5\nspan = (0, 1)\nstep(h=0.1)") == "nothing");
    BOOST_TEST(told("A2 = [[0, 0], [1/2, 0]]") == "A2 (line 3)");
    BOOST_TEST(told("def solve():\n    linear_order = 2") == "linear_order (line 4)");
}

BOOST_AUTO_TEST_CASE(what_cannot_be_read_is_refused_with_its_line) {
    BOOST_TEST(complaint("A = [[[[\nb = [1]") == "line 1, A: the brackets are not closed");
    BOOST_TEST(complaint("\nA = [[0, 0], [1, 0]\nb = [1/2, 1/2]") ==
               "line 2, A: the brackets are not closed");
    BOOST_TEST(complaint("A = [[0, 0],\n [1, 0]]\nb = [1/2,\n 1/0]") ==
               "line 4, b[2]: '1/0' division by zero");
    BOOST_TEST(complaint("A = [[0, 0], [g, 0]]\nb = [1/2, 1/2]") == "line 1, A: 'g' is unknown");
    BOOST_TEST(complaint("A = [[0, 0], [1, 0]]\nA *= 2\nb = [1/2, 1/2]") == "line 1, A: line 2 changes it");
    BOOST_TEST(complaint("A = [[0, 0], [1, 0]]\nfor i in x: pass\nA[i, 0] = 2\nb = [1/2, 1/2]") ==
               "line 1, A: line 3 computes elements of it");
    BOOST_TEST(complaint("A = [[0, 0], [1, 0]]\nb = [A[1], 1/2]")
                   .starts_with("line 2, b: 'A[...]', an element of it,"));
    BOOST_TEST(complaint("order = 4\nb = [1]")
                   .starts_with("no tableau: no arrays A and b that belong together; order"));
    BOOST_TEST(complaint("").starts_with("no tableau"));
}

// A hundred thousand times the same costs at most what a quadratic reader needs for a few thousand.
BOOST_AUTO_TEST_CASE(the_time_is_linear_in_the_source) {
    const auto repeated = [](std::string_view part, int times) {
        std::string text;
        for (int i = 0; i < times; ++i) text += part;
        return text;
    };
    for (const char* part : {"A=", "A ", "A: ", "A=\n", "A=[", "A = {\"A\":", "A{", "f(A=[", "return [1.5,",
                             "A[0]=", "order=1\n", "A << "}) {
        const auto begin = std::chrono::steady_clock::now();
        BOOST_TEST(complaint(repeated(part, 100000)) != "none");
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
        BOOST_TEST(seconds.count() < 20.0, part << ": " << seconds.count() << " s");
    }
    BOOST_TEST(complaint(std::string(300000, 'A') + " = [1.5, 2.5]") != "none");
}
