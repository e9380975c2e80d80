// POV-Ray 3.7.0.10.unofficial, trace()
// build: povray +IFILE +W1 +H1 -D -F -GA
// case: capped_cylinder 0x1.b038p-2 0x1.80e6p+0 0x1.a082p-2 0x0p+0 0x0p+0 0x0p+0 0x1.d2ff8p+0 ray 0x1.0e2p+0 0x1.0342p+2 0x1.7c9ap+1 -0x1.0bd7bf3e25f9p-2 -0x1.dd06b6e951a5cp-1 -0x1.021bdbc80d7p-2 range 0x1.a36e2eb1c432dp-14 0x1.312dp+23
// exact: hit 3.7348925541163062048..., at 0.078257874 0.571134357 2.03203494
// observed: at -0.20024931759302356 -0.4209046603340001 1.763649257202126
// wrong by: rayaudit judge --format double --convention direction=unit,ray=line,t_min=0.0001,t_max=10000000
#version 3.7;
global_settings { assumed_gamma 1 }
#declare N = <0, 0, 0>;
#declare Shape = cylinder { <0.422088623046875, 1.503509521484375, 0.40674591064453125>, <0.0, 0.0, 0.0>, 1.8242111206054688 }
#declare P = trace(Shape, <1.05517578125, 4.0509033203125, 2.97344970703125>, <-0.26156519715140636, -0.931691852551761, -0.25205939682506084>, N);
#fopen Out "/dev/stdout" write
#if (N.x = 0 & N.y = 0 & N.z = 0)
  #write(Out, "miss\n")
#else
  #write(Out, "at ", str(P.x, 0, 100), " ", str(P.y, 0, 100), " ", str(P.z, 0, 100), "\n")
#end
