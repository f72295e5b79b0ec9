// SPDX-License-Identifier: Apache-2.0
// The smallest host in C#: lights and changes of the visibility go in, the bytes to upload come out.
//
//     mcs SmallestHost.cs Litfog.cs && mono SmallestHost.exe
using System;
using static Litfog;

static class SmallestHost
{
    static void Main()
    {
        Require(litfog_updater_create(0.5, out IntPtr updater));
        Require(litfog_default_placed_light(out PlacedLight edge));
        edge.Light.Color = new Vector { X = 1, Y = 0.87, Z = 0.7 };
        edge.Light.Attenuation.Quadratic = 0.0019;
        edge.Light.DensityScale = 0.4;
        for (int i = 0; i < 60; ++i)
        {
            edge.Position = new Vector { X = 30, Z = -60 * i };
            Require(litfog_updater_add(updater, ref edge, out _));
        }
        Require(litfog_default_placed_light(out PlacedLight landing));
        landing.Light.Attenuation.Quadratic = 9.5e-5;
        landing.Light.Cone = new Cone { Profile = ConeProfile.Smoothstep, Inner = 0.09, Outer = 0.15 };
        landing.Position.Y = 3;
        landing.Carried = 1;
        Require(litfog_updater_add(updater, ref landing, out _));

        foreach (double visibility in new[] { 5000.0, 1500, 550, 200 })
        {
            Require(litfog_fog_from_visibility(FogMode.Exp, visibility, ContrastMor, out Fog fog));
            Require(litfog_updater_set_fog(updater, ref fog, out FogLightChanges changes));
            Require(litfog_updater_tables(updater, out FogLightTables tables));
            Require(litfog_updater_statistics(updater, out FogUpdateStatistics statistics));
            ulong bytes = (ulong)statistics.BytesDirty;
            float intensity = At<FogLightKind>(tables.Kinds, 1).ConeScaleIntensity.W;
            Console.WriteLine($"visibility {visibility,4} m: {bytes,3} bytes, landing lamp in fog {intensity:F3}");
            for (int i = 0; i < (int)changes.KindCount; ++i)
            {
                EntryRange range = At<EntryRange>(changes.Kinds, i);
                Console.WriteLine($"  upload kinds [{range.Begin}, {range.End})");
            }
            for (int i = 0; i < (int)changes.InstanceCount; ++i)
            {
                EntryRange range = At<EntryRange>(changes.Instances, i);
                Console.WriteLine($"  upload instances [{range.Begin}, {range.End})");
            }
        }
        litfog_updater_destroy(updater);
    }
}
