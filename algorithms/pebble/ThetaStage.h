#pragma once
/// \file
/// The last stage of BIBOX-theta: a theta graph (two vertices joined by three paths, its *arms*) with one
/// blank is solved by 3-cycles.
///
/// Notation: arms A, B, C of a, b, c inner vertices between p and q; the blank stands on p. A *turn* takes
/// the blank once around the cycle of two arms. One arm B is filled as a handle. On the cycle of A and C
/// remain L = a + c + 1 robots y_0 … y_{L−1}, which a turn shifts by one; what has to be sorted is their
/// cyclic order. With the turns α (along B, back along A) and γ (along B, back along C), and numbers counted
/// from q:
///
/// * b = 0: the commutator [α, γ] is the 3-cycle (y_{−1} y_0 y_1).
/// * b ≥ 2: D = [α, γ] = (y_{−1} y_1)(B_1 B_2), and D · D^(turned by 2) is the 3-cycle (y_{−1} y_1 y_3).
/// * b = 1: D = [α, γ] = (y_{−1} y_1)(B_1 y_0). E_k = (D · D^(turned by k))² is the 3-cycle (B_1 y_0 y_k) for
///   3 ≤ k ≤ L−3 or −k, and E_4^{−1} · E_{−4} is a 3-cycle on y_{−4}, y_0, y_4.
///
/// So the robots s = 1, 2 or 4 apart form, in one round, a list in which one robot can hop over two. Unless
/// b = 0, B is chosen such that the cycle of A and C has an even number of vertices: every theta graph has
/// such a cycle, then L is odd, and that round meets every robot.
///
/// Hops are even permutations. What is left for them is made even by one more push through B, before it is
/// filled, where the cycle of A and B has an odd number of vertices. O(n^2) hops at most, each of O(1) turns:
/// O(n^3) moves.

#include "algorithms/pebble/OneBlankBoard.h"
#include "framework/support/TerminationCondition.h"

#include <array>
#include <vector>

namespace mrpp
{

struct ThetaGraph
{
    Vertex p = 0;
    Vertex q = 0;
    std::array<std::vector<Vertex>, 3> arms; ///< inner vertices from p to q
};

/// Brings everybody home who stands on the theta graph, which may be part of a larger one.
/// False where the termination condition says stop.
/// \pre solvable; on the theta graph stand those that belong there, the blank among them, whose target is p;
/// no theta_0
bool solveTheta(OneBlankBoard &board, const ThetaGraph &theta, const TerminationCondition &ptc);

} // namespace mrpp
