// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANISOTROPIC_MESH_2_TEST_ARCHETYPES_ONLY_COPYABLE_H
#define ANISOTROPIC_MESH_2_TEST_ARCHETYPES_ONLY_COPYABLE_H

// What function objects have to be, and nothing else: they can be copied. Only
// classes that derive from this one can name what builds it.
class Only_copyable
{
protected:
  struct Made_on_purpose { explicit Made_on_purpose() {} };

public:
  explicit Only_copyable(Made_on_purpose) {}
  Only_copyable(const Only_copyable&) = default;
  Only_copyable& operator=(const Only_copyable&) = delete;
};

#endif // ANISOTROPIC_MESH_2_TEST_ARCHETYPES_ONLY_COPYABLE_H
