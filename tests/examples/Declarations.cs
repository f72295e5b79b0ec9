// SPDX-License-Identifier: Apache-2.0
// Calls what the smallest host in C# does not, by the same declarations. The argument is lamp.json.
using System;
using System.Text;
using static Litfog;

static class Declarations
{
    static void Expect(bool condition, string claim)
    {
        if (!condition) throw new Exception(claim + ": false");
    }

    static string ErrorOf(Status status)
    {
        try { Require(status); }
        catch (ArgumentException error) { return error.Message; }
        return "";
    }

    static void Main(string[] arguments)
    {
        byte[] name = new byte[16];
        Require(litfog_read_light(Encoding.UTF8.GetBytes(arguments[0] + "\0"), out Light lamp, name, (UIntPtr)16));
        Expect(Encoding.UTF8.GetString(name, 0, 7) == "a lamp\0", "its name");
        Expect(lamp.Color.X == 1 && lamp.Color.Y == 0.5 && lamp.Color.Z == 0.25, "its colour");
        Expect(lamp.Attenuation.Linear == 0.5 && lamp.Attenuation.Quadratic == 0.25, "its attenuation");
        Expect(lamp.Threshold == 0.125 && lamp.DensityScale == 0.5, "its threshold and scale");
        Expect(lamp.Cone.Profile == ConeProfile.Smoothstep && lamp.Cone.Outer > lamp.Cone.Inner, "its cone");
        Require(litfog_fog_from_visibility(FogMode.Exp2, 2, ContrastMor, out Fog fog));
        Expect(fog.Mode == FogMode.Exp2, "fog");
        string error = ErrorOf(litfog_fog_from_visibility(FogMode.Exp, -1, ContrastMor, out _));
        Expect(error == "visibility = -1: must be >= 0", error);
        Require(litfog_solve(ref lamp, ref fog, out FogIntensity solved));
        Expect(solved.Status == 0 && solved.Intensity > 0, "a solve");
        Expect(solved.PeakRange > 0 && solved.PeakRange < solved.Extent, "its result");
        Require(litfog_updater_create(0.5, out IntPtr updater));
        Require(litfog_default_placed_light(out PlacedLight placed));
        placed.Light = lamp;
        Require(litfog_updater_add(updater, ref placed, out LightHandle handle));
        placed.Position = new Vector { X = 1, Y = 2, Z = 3 };
        placed.Direction = new Vector { Y = -1 };
        placed.Carried = 1;
        Require(litfog_updater_change(updater, handle, ref placed));
        Require(litfog_updater_set_fog(updater, ref fog, out _));
        Require(litfog_updater_tables(updater, out FogLightTables tables));
        Expect((int)tables.InstanceCount == 1, "tables");
        Vector4 position = At<Vector4>(tables.Instances, 0), axis = At<Vector4>(tables.Instances, 1);
        int kind = (int)position.W;
        Expect(kind < (int)tables.KindCount, "its kind");
        Expect(position.X == 1 && position.Y == 2 && position.Z == 3, "its position");
        Expect(axis.X == 0 && axis.Y == -1 && axis.Z == 0 && axis.W == 2, "its axis and profile");
        Expect(At<FogLightKind>(tables.Kinds, kind).ConeScaleIntensity.W == (float)solved.Intensity, "its intensity");
        Require(litfog_updater_remove(updater, handle));
        Expect(litfog_updater_remove(updater, handle) == Status.InvalidArgument, "a second removal");
        litfog_updater_destroy(updater);
    }
}
