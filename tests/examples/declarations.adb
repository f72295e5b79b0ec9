--  SPDX-License-Identifier: Apache-2.0
--  Calls what the smallest host in Ada does not, by the same declarations. The argument is lamp.json.

with Ada.Command_Line;
with Interfaces.C.Strings;
with Litfog; use Litfog;

procedure Declarations is
   use Interfaces.C;

   procedure Expect (Condition : Boolean; Claim : String) is
   begin
      if not Condition then
         raise Program_Error with Claim & ": false; " & Strings.Value (Last_Error);
      end if;
   end Expect;

   Lamp    : Light;
   Name    : char_array (0 .. 15);
   Weather : Fog;
   Solved  : Fog_Intensity;
   Placed  : Placed_Light;
   Lights  : Updater;
   Handle  : Light_Handle;
   Changes : Fog_Light_Changes;
   Now     : Fog_Light_Tables;
   Kind    : C_float;
begin
   Expect (Read_Light (To_C (Ada.Command_Line.Argument (1)), Lamp, Name, Name'Length) = Ok, "a light is read");
   Expect (To_Ada (Name) = "a lamp", "its name");
   Expect (Lamp.Color = (1.0, 0.5, 0.25) and Lamp.Threshold = 0.125 and Lamp.Density_Scale = 0.5, "its fields");
   Expect (Lamp.Falloff = (1.0, 0.5, 0.25), "its attenuation");
   Expect (Lamp.Beam.Profile = Smoothstep and Lamp.Beam.Outer > Lamp.Beam.Inner, "its cone");
   Expect (Fog_From_Visibility (Exp2, 2.0, Contrast_Mor, Weather) = Ok, "fog");
   Expect (Weather.Mode = Exp2 and Weather.Density > 0.0, "its fields");
   Expect (Fog_From_Visibility (Exp, -1.0, Contrast_Mor, Weather) = Invalid_Argument, "a wrong visibility");
   Expect (String'(Strings.Value (Last_Error)) = "visibility = -1: must be >= 0", "its error");
   Expect (Solve (Lamp, Weather, Solved) = Ok and Solved.Ended = 0, "a solve");
   Expect (Solved.Intensity > 0.0 and Solved.Peak_Range > 0.0 and Solved.Peak_Range < Solved.Extent, "its result");
   Expect (Create (0.5, Lights) = Ok and Default_Placed_Light (Placed) = Ok, "an updater");
   Placed.Kind := Lamp;
   Expect (Add (Lights, Placed, Handle) = Ok and Set_Fog (Lights, Weather, Changes) = Ok, "a light");
   Placed.Position := (1.0, 2.0, 3.0);
   Placed.Direction := (0.0, -1.0, 0.0);
   Placed.Carried := 1;
   Expect (Change (Lights, Handle, Placed) = Ok and Set_Fog (Lights, Weather, Changes) = Ok, "a change");
   Expect (Tables (Lights, Now) = Ok and Now.Instance_Count = 1, "tables");
   Kind := Now.Instances (0).Position_Kind (4);
   Expect (size_t (Kind) < Now.Kind_Count, "its kind");
   Expect (Now.Instances (0).Position_Kind = (1.0, 2.0, 3.0, Kind), "its position");
   Expect (Now.Instances (0).Axis_Profile = (0.0, -1.0, 0.0, 2.0), "its axis and profile");
   Expect (Now.Kinds (size_t (Kind)).Cone_Scale_Intensity (4) = C_float (Solved.Intensity), "its intensity");
   Expect (Remove (Lights, Handle) = Ok and Remove (Lights, Handle) = Invalid_Argument, "a removal");
   Destroy (Lights);
end Declarations;
