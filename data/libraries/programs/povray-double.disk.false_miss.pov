// POV-Ray 3.7.0.10.unofficial, trace()
// build: povray +IFILE +W1 +H1 -D -F -GA
// case: disk 0x0p+0 0x1.183cfadep+1 0x0p+0 0x1.16e6505d078bp-2 0x1.31ffb32d0cf7p-2 0x1.d4486f95bb78p-1 0x1p+0 ray 0x1.7e7cd7bcp+0 0x0p+0 0x1.14e1a988p-2 -0x1.24b93e3bd093ep-1 0x1.a12f2d07bc6ap-1 -0x1.8912c635c05p-4 range 0x1.a36e2eb1c432dp-14 0x1.312dp+23
// exact: hit 994355217591489789952 / 505050000271039558693 = 1.9688252985998618946...
// observed: miss
// wrong by: rayaudit judge --format double --convention direction=unit,ray=line,t_min=0.0001,t_max=10000000
#version 3.7;
global_settings { assumed_gamma 1 }
#declare N = <0, 0, 0>;
#declare Shape = disc { <0.0, 2.1893609603866935, 0.0>, <0.2723629528790168, 0.2988269802328807, 0.9146151418951689>, 1.0 }
#declare P = trace(Shape, <1.4940924486145377, 0.0, 0.27039208309724927>, <-0.5717257926956234, 0.8148130485480642, -0.09596517015235762>, N);
#fopen Out "/dev/stdout" write
#if (N.x = 0 & N.y = 0 & N.z = 0)
  #write(Out, "miss\n")
#else
  #write(Out, "at ", str(P.x, 0, 100), " ", str(P.y, 0, 100), " ", str(P.z, 0, 100), "\n")
#end
