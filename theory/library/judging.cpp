// SPDX-License-Identifier: BSL-1.0
// Certificates.
#include "stagecraft/theory/judging/certificate-inl.hpp"
#include "stagecraft/theory/judging/certify-inl.hpp"
#include "stagecraft/theory/judging/enclosed_report-inl.hpp"
#include "stagecraft/theory/judging/family_report-inl.hpp"
#include "stagecraft/theory/judging/jumps_seen-inl.hpp"
#include "stagecraft/theory/judging/principal_error-inl.hpp"
#include "stagecraft/theory/judging/properties-inl.hpp"
#include "stagecraft/theory/judging/rounded_properties-inl.hpp"
#include "stagecraft/theory/judging/stability_report-inl.hpp"
#include "stagecraft/theory/judging/subject-inl.hpp"
#include "stagecraft/theory/judging/subject_spectrum-inl.hpp"
