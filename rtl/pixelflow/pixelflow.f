// File list of the pixel processors; paths from the project's root. Verilator takes rtl/pixelflow.vlt with its waivers too.
+incdir+rtl/pixelflow
rtl/pixelflow/pixelflow_pkg.sv
rtl/pixelflow/pixel_element.sv
rtl/pixelflow/pixel_memory.sv
rtl/pixelflow/pixel_processor.sv
rtl/pixelflow/pixel_row.sv
rtl/pixelflow/stream_buffer.sv
rtl/pixelflow/instruction_sequencer.sv
rtl/pixelflow/communication_buffer.sv
rtl/pixelflow/composition_port.sv
rtl/pixelflow/pixel_chip.sv
