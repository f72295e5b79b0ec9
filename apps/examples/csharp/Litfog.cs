// SPDX-License-Identifier: Apache-2.0
// litfog.h for C#: fog, lights, light files, solve and updater. What is left out follows the same pattern.
using System;
using System.Runtime.InteropServices;

public static class Litfog
{
    const string Library = "liblitfog_c.so.0.1";  // of the package litfog-runtime

    public enum Status { Ok, InvalidArgument, BadFile, OutOfMemory, Fault }
    public enum FogMode { Exp, Exp2 }
    public enum ConeProfile { None, Cosine, Smoothstep }
    public const double ContrastMor = 0.05;

    [StructLayout(LayoutKind.Sequential)]
    public struct Vector { public double X, Y, Z; }

    [StructLayout(LayoutKind.Sequential)]
    public struct Vector4 { public float X, Y, Z, W; }

    [StructLayout(LayoutKind.Sequential)]
    public struct Fog { public FogMode Mode; public double Density; }

    [StructLayout(LayoutKind.Sequential)]
    public struct Attenuation { public double Constant, Linear, Quadratic; }

    [StructLayout(LayoutKind.Sequential)]
    public struct Cone { public ConeProfile Profile; public double HalfAngle, Exponent, Inner, Outer; }

    [StructLayout(LayoutKind.Sequential)]
    public struct SingleFlash { public double Start, Duration, Intensity; }

    [StructLayout(LayoutKind.Sequential)]
    public struct Flash
    {
        public double Period;
        public UIntPtr Count;
        public SingleFlash First, Second, Third, Fourth, Fifth, Sixth, Seventh, Eighth;
    }

    [StructLayout(LayoutKind.Sequential)]
    public struct Light
    {
        public Vector Color;
        public Attenuation Attenuation;
        public double Threshold;
        public Cone Cone;
        public double DensityScale, SourceRadius;
        public Flash Flash;
    }

    [StructLayout(LayoutKind.Sequential)]
    public struct PlacedLight { public Light Light; public Vector Position, Direction; public int Carried; }

    [StructLayout(LayoutKind.Sequential)]
    public struct FogIntensity { public double Intensity, PeakRange, Extent; public int Status; }

    [StructLayout(LayoutKind.Sequential)]
    public struct LightHandle { public uint Slot, Generation; }

    [StructLayout(LayoutKind.Sequential)]
    public struct EntryRange { public UIntPtr Begin, End; }

    [StructLayout(LayoutKind.Sequential)]
    public struct FogLightKind { public Vector4 AttenuationExtent, ConeScaleIntensity; }

    /// Arrays of EntryRange.
    [StructLayout(LayoutKind.Sequential)]
    public struct FogLightChanges
    {
        public IntPtr Kinds;
        public UIntPtr KindCount;
        public IntPtr Instances;
        public UIntPtr InstanceCount;
        public IntPtr Sources;
        public UIntPtr SourceCount;
    }

    /// Arrays of FogLightKind and of three Vector4 an instance.
    [StructLayout(LayoutKind.Sequential)]
    public struct FogLightTables
    {
        public IntPtr Kinds;
        public UIntPtr KindCount;
        public IntPtr Instances;
        public UIntPtr InstanceCount;
    }

    [StructLayout(LayoutKind.Sequential)]
    public struct FogUpdateStatistics { public UIntPtr KindsSolved, KindsSkipped, LightsSkipped, BytesDirty, SourcesSolved; }

    [DllImport(Library)] static extern IntPtr litfog_last_error();
    [DllImport(Library)]
    public static extern Status litfog_fog_from_visibility(FogMode mode, double metres, double contrast, out Fog fog);
    [DllImport(Library)] public static extern Status litfog_default_placed_light(out PlacedLight light);
    [DllImport(Library)]
    public static extern Status litfog_read_light(byte[] path, out Light light, byte[] name, UIntPtr nameSize);
    [DllImport(Library)]
    public static extern Status litfog_solve(ref Light light, ref Fog fog, out FogIntensity solution);
    [DllImport(Library)] public static extern Status litfog_updater_create(double skipBudget255, out IntPtr updater);
    [DllImport(Library)] public static extern void litfog_updater_destroy(IntPtr updater);
    [DllImport(Library)]
    public static extern Status litfog_updater_add(IntPtr updater, ref PlacedLight light, out LightHandle handle);
    [DllImport(Library)]
    public static extern Status litfog_updater_change(IntPtr updater, LightHandle handle, ref PlacedLight light);
    [DllImport(Library)] public static extern Status litfog_updater_remove(IntPtr updater, LightHandle handle);
    [DllImport(Library)]
    public static extern Status litfog_updater_set_fog(IntPtr updater, ref Fog fog, out FogLightChanges changes);
    [DllImport(Library)] public static extern Status litfog_updater_tables(IntPtr updater, out FogLightTables tables);
    [DllImport(Library)]
    public static extern Status litfog_updater_statistics(IntPtr updater, out FogUpdateStatistics statistics);

    /// Throws what a call that failed on this thread said.
    public static void Require(Status status)
    {
        if (status != Status.Ok) throw new ArgumentException(Marshal.PtrToStringAnsi(litfog_last_error()));
    }

    /// Entry i of an array of structs.
    public static T At<T>(IntPtr array, int i)
    {
        return (T)Marshal.PtrToStructure(array + i * Marshal.SizeOf(typeof(T)), typeof(T));
    }
}
