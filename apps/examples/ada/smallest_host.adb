--  SPDX-License-Identifier: Apache-2.0
--  The smallest host in Ada: lights and changes of the visibility go in, the bytes to upload come out.
--
--     gnatmake smallest_host.adb -largs -llitfog_c

with Ada.Text_IO;
with Interfaces.C.Strings;
with Litfog; use Litfog;

procedure Smallest_Host is
   use Interfaces.C;

   procedure Require (Call : Status) is
   begin
      if Call /= Ok then
         raise Program_Error with Strings.Value (Last_Error);
      end if;
   end Require;

   Lights  : Updater;
   Handle  : Light_Handle;
   Lamp    : Placed_Light;
   Weather : Fog;
   Changes : Fog_Light_Changes;
   Now     : Fog_Light_Tables;
   package Text is new Ada.Text_IO.Float_IO (Real);
begin
   Require (Create (0.5, Lights));
   Require (Default_Placed_Light (Lamp));
   Lamp.Kind.Color := (1.0, 0.87, 0.7);
   Lamp.Kind.Falloff.Quadratic := 0.0019;
   Lamp.Kind.Density_Scale := 0.4;
   for I in 0 .. 59 loop  --  runway edge
      Lamp.Position := (30.0, 0.0, -60.0 * Real (I));
      Require (Add (Lights, Lamp, Handle));
   end loop;
   Require (Default_Placed_Light (Lamp));  --  landing lamp
   Lamp.Kind.Falloff.Quadratic := 9.5E-5;
   Lamp.Kind.Beam := (Profile => Smoothstep, Inner => 0.09, Outer => 0.15, others => 0.0);
   Lamp.Position := (0.0, 3.0, 0.0);
   Lamp.Carried := 1;
   Require (Add (Lights, Lamp, Handle));

   for Visibility of Vector'(5000.0, 1500.0, 200.0) loop
      Require (Fog_From_Visibility (Exp, Visibility, Contrast_Mor, Weather));
      Require (Set_Fog (Lights, Weather, Changes));
      Require (Tables (Lights, Now));
      Ada.Text_IO.Put ("visibility");
      Text.Put (Visibility, Fore => 5, Aft => 0, Exp => 0);
      Ada.Text_IO.Put (" m, landing lamp in fog");
      Text.Put (Real (Now.Kinds (1).Cone_Scale_Intensity (4)), Fore => 2, Aft => 3, Exp => 0);
      Ada.Text_IO.New_Line;
      for I in 1 .. Changes.Kind_Count loop
         Ada.Text_IO.Put_Line
           ("  upload kinds [" & Changes.Kinds (I - 1).First'Image & "," & Changes.Kinds (I - 1).Beyond'Image & ")");
      end loop;
      for I in 1 .. Changes.Instance_Count loop
         Ada.Text_IO.Put_Line
           ("  upload instances [" & Changes.Instances (I - 1).First'Image & ","
            & Changes.Instances (I - 1).Beyond'Image & ")");
      end loop;
   end loop;
   Destroy (Lights);
end Smallest_Host;
