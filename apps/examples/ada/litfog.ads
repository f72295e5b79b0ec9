--  SPDX-License-Identifier: Apache-2.0
--  litfog.h for Ada: fog, lights, light files, solve and updater. All of it, less readable, is
--
--     echo '#include <litfog/c/litfog.h>' > all.h && gcc -fdump-ada-spec all.h

with Interfaces;
with Interfaces.C;
with Interfaces.C.Strings;

package Litfog is
   use Interfaces.C;
   subtype Real is double;
   type Vector is array (1 .. 3) of Real with Convention => C;
   type Vector4 is array (1 .. 4) of C_float with Convention => C;

   type Status is (Ok, Invalid_Argument, Bad_File, Out_Of_Memory, Fault)
     with Convention => C, Size => 32;
   function Last_Error return Strings.chars_ptr
     with Import, Convention => C, External_Name => "litfog_last_error";

   type Fog_Mode is (Exp, Exp2) with Convention => C, Size => 32;
   type Fog is record
      Mode    : Fog_Mode;
      Density : Real;
   end record with Convention => C;
   Contrast_Mor : constant := 0.05;
   function Fog_From_Visibility
     (Mode : Fog_Mode; Metres, Contrast : Real; Result : out Fog) return Status
     with Import, Convention => C, External_Name => "litfog_fog_from_visibility";

   type Attenuation is record
      Const, Linear, Quadratic : Real;
   end record with Convention => C;
   type Cone_Profile is (None, Cosine, Smoothstep) with Convention => C, Size => 32;
   type Cone is record
      Profile                             : Cone_Profile;
      Half_Angle, Exponent, Inner, Outer : Real;
   end record with Convention => C;
   type Single_Flash is record
      Start, Duration, Intensity : Real;
   end record with Convention => C;
   type Single_Flashes is array (1 .. 8) of Single_Flash with Convention => C;
   type Flash is record
      Period  : Real;
      Count   : size_t;
      Flashes : Single_Flashes;
   end record with Convention => C;
   type Light is record
      Color         : Vector;
      Falloff       : Attenuation;
      Threshold     : Real;
      Beam          : Cone;
      Density_Scale : Real;
      Source_Radius : Real;
      Flashing      : Flash;
   end record with Convention => C;
   type Placed_Light is record
      Kind                : Light;
      Position, Direction : Vector;
      Carried             : int;
   end record with Convention => C;
   function Default_Placed_Light (Result : out Placed_Light) return Status
     with Import, Convention => C, External_Name => "litfog_default_placed_light";
   function Read_Light
     (Path : char_array; Result : in out Light; Name : out char_array; Name_Size : size_t) return Status
     with Import, Convention => C, External_Name => "litfog_read_light";

   type Fog_Intensity is record
      Intensity, Peak_Range, Extent : Real;
      Ended                         : int;
   end record with Convention => C;
   function Solve (From : Light; Into : Fog; Result : in out Fog_Intensity) return Status
     with Import, Convention => C, External_Name => "litfog_solve";

   type Updater is limited private;
   type Light_Handle is record
      Slot, Generation : Interfaces.Unsigned_32 := 0;
   end record with Convention => C_Pass_By_Copy;
   type Entry_Range is record
      First, Beyond : size_t;
   end record with Convention => C;
   type Entry_Ranges is array (size_t) of Entry_Range with Convention => C;
   type Fog_Light_Changes is record
      Kinds          : access constant Entry_Ranges;
      Kind_Count     : size_t := 0;
      Instances      : access constant Entry_Ranges;
      Instance_Count : size_t := 0;
      Sources        : access constant Entry_Ranges;
      Source_Count   : size_t := 0;
   end record with Convention => C;
   type Fog_Light_Kind is record
      Attenuation_Extent, Cone_Scale_Intensity : Vector4;
   end record with Convention => C;
   type Fog_Light_Instance is record
      Position_Kind, Axis_Profile, Color : Vector4;
   end record with Convention => C;
   type Kind_Table is array (size_t) of Fog_Light_Kind with Convention => C;
   type Instance_Table is array (size_t) of Fog_Light_Instance with Convention => C;
   type Fog_Light_Tables is record
      Kinds          : access constant Kind_Table;
      Kind_Count     : size_t := 0;
      Instances      : access constant Instance_Table;
      Instance_Count : size_t := 0;
   end record with Convention => C;

   type Fog_Update_Statistics is record
      Kinds_Solved, Kinds_Skipped, Lights_Skipped, Bytes_Dirty, Sources_Solved : size_t := 0;
   end record with Convention => C;

   function Create (Skip_Budget_255 : Real; Result : out Updater) return Status
     with Import, Convention => C, External_Name => "litfog_updater_create";
   procedure Destroy (Self : Updater)
     with Import, Convention => C, External_Name => "litfog_updater_destroy";
   function Add (Self : Updater; Added : Placed_Light; Result : out Light_Handle) return Status
     with Import, Convention => C, External_Name => "litfog_updater_add";
   function Change (Self : Updater; Handle : Light_Handle; Changed : Placed_Light) return Status
     with Import, Convention => C, External_Name => "litfog_updater_change";
   function Remove (Self : Updater; Handle : Light_Handle) return Status
     with Import, Convention => C, External_Name => "litfog_updater_remove";
   function Set_Fog (Self : Updater; To : Fog; Result : in out Fog_Light_Changes) return Status
     with Import, Convention => C, External_Name => "litfog_updater_set_fog";
   function Tables (Self : Updater; Result : in out Fog_Light_Tables) return Status
     with Import, Convention => C, External_Name => "litfog_updater_tables";
   function Statistics (Self : Updater; Result : in out Fog_Update_Statistics) return Status
     with Import, Convention => C, External_Name => "litfog_updater_statistics";

private
   type Store is null record;
   type Updater is access Store with Convention => C;
end Litfog;
