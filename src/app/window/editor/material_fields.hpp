#pragma once
/// Of what a thing is made, and with which layers it meets.

#include "app/window/editor/field_set.hpp"

namespace flipside::app {

/// The material of the thing at that path, and its numbers, which all that are of it share.
void material_fields(Editor& editor, const FieldSet& fields, ControlPlaces& places, const lab::Path& thing);
void layer_fields(Editor& editor, const FieldSet& fields, ControlPlaces& places, const lab::Path& thing);

}  // namespace flipside::app
