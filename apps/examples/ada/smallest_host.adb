--  SPDX-License-Identifier: Apache-2.0
--  The smallest host in Ada: lights and changes of the visibility go in, the bytes to upload come out.
--
--     gnatmake smallest_host.adb -largs -llitfog_c

with Ada.Integer_Text_IO;
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

   procedure Put_Upload (Table : String; Entries : Entry_Range) is
      First  : constant String := Entries.First'Image;  --  begins with a blank
      Beyond : constant String := Entries.Beyond'Image;
   begin
      Ada.Text_IO.Put_Line ("  upload " & Table & " [" & First (2 .. First'Last) & "," & Beyond & ")");
   end Put_Upload;

   Lights  : Updater;
   Handle  : Light_Handle;
   Lamp    : Placed_Light;
   Weather : Fog;
   Changes : Fog_Light_Changes;
   Now     : Fog_Light_Tables;
   Done    : Fog_Update_Statistics;
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

   for Visibility of Vector4'(5000.0, 1500.0, 550.0, 200.0) loop
      Require (Fog_From_Visibility (Exp, Real (Visibility), Contrast_Mor, Weather));
      Require (Set_Fog (Lights, Weather, Changes));
      Require (Tables (Lights, Now));
      Require (Statistics (Lights, Done));
      Ada.Text_IO.Put ("visibility");
      Ada.Integer_Text_IO.Put (Integer (Visibility), Width => 5);
      Ada.Text_IO.Put (" m: ");
      Ada.Integer_Text_IO.Put (Integer (Done.Bytes_Dirty), Width => 3);
      Ada.Text_IO.Put (" bytes, landing lamp in fog");
      Text.Put (Real (Now.Kinds (1).Cone_Scale_Intensity (4)), Fore => 2, Aft => 3, Exp => 0);
      Ada.Text_IO.New_Line;
      for I in 1 .. Changes.Kind_Count loop
         Put_Upload ("kinds", Changes.Kinds (I - 1));
      end loop;
      for I in 1 .. Changes.Instance_Count loop
         Put_Upload ("instances", Changes.Instances (I - 1));
      end loop;
   end loop;
   Destroy (Lights);
end Smallest_Host;
