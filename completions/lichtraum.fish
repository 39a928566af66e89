# fish completion for lichtraum

set -l commands render view preview check info devices doctor
set -l first "not __fish_seen_subcommand_from $commands"
set -l any "__fish_seen_subcommand_from $commands"
set -l scenes '__fish_seen_subcommand_from render view preview check info'
set -l render '__fish_seen_subcommand_from render'
set -l seen '__fish_seen_subcommand_from render view preview'
set -l view '__fish_seen_subcommand_from view'
set -l preview '__fish_seen_subcommand_from preview'
set -l json '__fish_seen_subcommand_from render info devices'

complete -c lichtraum -f
complete -c lichtraum -n $first -s V -l version -d 'Print the version'
complete -c lichtraum -n $first -a render -d 'Draw scenes to pictures'
complete -c lichtraum -n $first -a view -d 'Open a window on a scene'
complete -c lichtraum -n $first -a preview -d 'Show a scene in the terminal'
complete -c lichtraum -n $first -a check -d 'Report what is wrong in scenes'
complete -c lichtraum -n $first -a info -d 'Tell what is in a scene'
complete -c lichtraum -n $first -a devices -d 'List what can draw'
complete -c lichtraum -n $first -a doctor -d 'Test every device'

complete -c lichtraum -s h -l help -d 'Show help'
complete -c lichtraum -n $any -s q -l quiet -d 'Say nothing but errors'
complete -c lichtraum -n $any -s v -l verbose -d 'Say more'

complete -c lichtraum -n $scenes -k -a '(__fish_complete_suffix .glb .obj .ply .sdf)'
complete -c lichtraum -n $scenes -l strict -d 'Accept the standard only'
complete -c lichtraum -n $scenes -l keep-going -d 'Leave faulty statements out'
complete -c lichtraum -n $scenes -l scene -x -d 'Scene of a glTF file'
complete -c lichtraum -n $scenes -l time -x -d 'Pose of the animation at that time'
complete -c lichtraum -n $scenes -l animation -x -d 'Animation that --time is for'
complete -c lichtraum -n $scenes -l max-texture -x -d 'Make pictures with a longer side smaller'
complete -c lichtraum -n $scenes -l transform-order -x -a 'parent local' -d 'Frame a transform happens in'
complete -c lichtraum -n $scenes -l rotation -x -a 'right left' -d 'Handedness of rotations'
complete -c lichtraum -n $scenes -l material-extras -x -a 'reflectance transmittance opacity ior ignore' \
    -d 'What more numbers mean'
complete -c lichtraum -n $scenes -l allow-path -x -a '(__fish_complete_directories)' -d 'Folder a scene may use'

complete -c lichtraum -n $render -s o -l output -r -F -d 'Write to this file'
complete -c lichtraum -n $render -l format -x -a 'png ppm jpg exr pfm' -d 'Picture format'
complete -c lichtraum -n $render -l output-dir -x -a '(__fish_complete_directories)' -d 'Where pictures go'
complete -c lichtraum -n $render -l bits -x -a '8 16' -d 'Bits a channel'
complete -c lichtraum -n $render -l quality -x -d 'Of .jpg, 1 to 100'
complete -c lichtraum -n $render -l ppm-ascii -d 'Write .ppm as text'
complete -c lichtraum -n $json -l json -d 'Print JSON'
complete -c lichtraum -n $render -l size -x -a '640x480 1280x720 1920x1080 3840x2160' -d 'Pixels'
complete -c lichtraum -n $render -l frames -x -d 'Frames of a model\'s animation, A..B'
complete -c lichtraum -n $render -l fps -x -a '24 25 30 60' -d 'Frames a second'
complete -c lichtraum -n $render -l turntable -x -d 'Pictures around the scene'
complete -c lichtraum -n $render -l resume -d 'Leave what is there already'
complete -c lichtraum -n $render -l region -x -d 'X,Y,WIDTH,HEIGHT'
complete -c lichtraum -n $seen -l camera -x -d 'Look through this camera'
complete -c lichtraum -n $seen -l root -x -d 'Draw this shape only'
complete -c lichtraum -n $render -l aov -x -a 'picture depth normal id' -d 'Instead of the picture'
complete -c lichtraum -n $seen -l samples -x -a '1 2x2 4x4 8x8 16 64' -d 'Samples a pixel'
complete -c lichtraum -n $render -l depth -x -d 'Mirrors and glass in a row'
complete -c lichtraum -n $render -l seed -x -d 'Of random samples'
complete -c lichtraum -n $render -l tonemap -x -a 'auto none reinhard' -d 'From radiance to shown values'
complete -c lichtraum -n $render -l transfer -x -a 'linear srgb' -d 'From linear to stored values'
complete -c lichtraum -n $render -l traversal -x -a 'auto scalar wide packet' -d 'How rays find what they hit'
complete -c lichtraum -n $seen -l device -x -a 'cpu gpu reference' -d 'What draws'

complete -c lichtraum -n $preview -l size -x -d 'Columns and rows of characters'
complete -c lichtraum -n $preview -l graphics -x -a 'auto blocks kitty sixel' -d 'What the terminal shows'

complete -c lichtraum -n $view -l watch -d 'Read the scene again when it is saved'
complete -c lichtraum -n $view -l size -x -d 'Of the window'
complete -c lichtraum -n $view -l depth -x -d 'Mirrors and glass in a row'
